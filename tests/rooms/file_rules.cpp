#include "rooms/file_rules.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <sstream>

namespace cdfr::rooms {
namespace {

constexpr std::size_t most_lines = 600;

bool is_code(const SourceFile& file) {
  const std::string name = file.name();
  if (name == "CMakeLists.txt" || name.find('.') == std::string::npos) return true;
  return std::ranges::any_of(std::array{".h", ".cpp", ".cmake", ".in", ".py", ".sh"},
                             [&](const char* end) { return file.has_extension(end); });
}

bool is_cmake(const SourceFile& file) {
  return file.name() == "CMakeLists.txt" || file.has_extension(".cmake") || file.has_extension(".cmake.in");
}

/// The words of the CMakeLists.txt that is closest above the file, or nothing.
std::vector<std::string> listed_beside(const SourceTree& tree, const SourceFile& file) {
  const std::string list = file.path.substr(0, file.path.rfind('/') + 1) + "CMakeLists.txt";
  std::vector<std::string> words;
  for (const SourceFile& other : tree.files) {
    if (other.path != list) continue;
    std::string text = other.text;
    std::ranges::replace_if(
        text, [](char c) { return c == '(' || c == ')'; }, ' ');
    std::istringstream in(text);
    for (std::string word; in >> word;) words.push_back(word);
  }
  return words;
}

bool includes_any_of(const SourceFile& file, std::initializer_list<std::string_view> starts) {
  return std::ranges::any_of(file.includes, [&](const Include& include) {
    return std::ranges::any_of(starts, [&](std::string_view s) { return include.path.starts_with(s); });
  });
}

void check_library_file(const SourceTree& tree, const SourceFile& file,
                        std::vector<std::string>& violations) {
  const std::string top = file.part(0);
  if (top != "src" && top != "include") return;
  if (includes_any_of(file, {"iostream"})) violations.push_back(file.path + ": <iostream> in the library");
  if (file.has_extension(".h") && file.text.find("\n#pragma once\n") == std::string::npos) {
    violations.push_back(file.path + ": no #pragma once");
  }
  if (top == "include" && file.name() != "eigen.h" &&
      includes_any_of(file, {"tbb/", "oneapi/", "Eigen/", "unsupported/Eigen/"})) {
    violations.push_back(file.path + ": a public header names TBB or Eigen");
  }
  if (top == "src" && file.has_extension(".cpp")) {
    const std::vector<std::string> listed = listed_beside(tree, file);
    if (std::ranges::find(listed, file.name()) == listed.end()) {
      violations.push_back(file.path + ": not listed in the CMakeLists.txt beside it");
    }
  }
}

void check_file(const SourceTree& tree, const SourceFile& file, std::vector<std::string>& violations) {
  if (is_code(file) && file.lines > most_lines) {
    violations.push_back(file.path + ": " + std::to_string(file.lines) + " lines, more than " +
                         std::to_string(most_lines));
  }
  // Only the test that compiles every public header alone lists them by itself.
  if (is_cmake(file) && file.path != "tests/headers/CMakeLists.txt" &&
      file.text.find("(GLOB") != std::string::npos) {
    violations.push_back(file.path + ": sources are listed, not globbed");
  }
  check_library_file(tree, file, violations);
}

}  // namespace

std::vector<std::string> file_violations(const SourceTree& tree) {
  std::vector<std::string> violations;
  for (const std::string& folder : tree.empty_folders) violations.push_back(folder + ": empty folder");
  for (const SourceFile& file : tree.files) check_file(tree, file, violations);
  return violations;
}

}  // namespace cdfr::rooms
