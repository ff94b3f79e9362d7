#include "rooms/source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace cdfr::rooms {
namespace {

namespace fs = std::filesystem;

std::vector<Include> includes_of(const std::string& text) {
  std::vector<Include> found;
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    char hash = 0;
    std::string rest;
    if (!(words >> hash) || hash != '#' || !std::getline(words >> std::ws, rest)) continue;
    if (!rest.starts_with("include")) continue;
    const std::size_t open = rest.find_first_of("\"<");
    if (open == std::string::npos) continue;
    const std::size_t close = rest.find(rest[open] == '<' ? '>' : '"', open + 1);
    if (close == std::string::npos) continue;
    found.push_back({number, rest.substr(open + 1, close - open - 1), rest[open] == '"'});
  }
  return found;
}

SourceFile read_source_file(const fs::path& root, const fs::path& path) {
  SourceFile file;
  file.path = path.lexically_relative(root).generic_string();
  std::ifstream in(path, std::ios::binary);
  file.text.assign(std::istreambuf_iterator<char>(in), {});
  file.lines = static_cast<std::size_t>(std::count(file.text.begin(), file.text.end(), '\n'));
  file.includes = includes_of(file.text);
  return file;
}

}  // namespace

std::string SourceFile::part(std::size_t k) const {
  std::istringstream parts(path);
  std::string one;
  for (std::size_t i = 0; std::getline(parts, one, '/'); ++i) {
    if (i == k) return one;
  }
  return {};
}

std::string SourceFile::name() const { return path.substr(path.rfind('/') + 1); }

bool SourceFile::has_extension(std::string_view extension) const { return path.ends_with(extension); }

bool SourceTree::has(const std::string& path) const { return fs::is_regular_file(root / path); }

SourceTree read_source_tree(const fs::path& root) {
  SourceTree tree;
  tree.root = root;
  for (const char* top : {"src", "include", "tools", "bench", "tests"}) {
    if (!fs::is_directory(root / top)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
      if (entry.is_directory() && fs::is_empty(entry.path())) {
        tree.empty_folders.push_back(entry.path().lexically_relative(root).generic_string());
      }
      if (entry.is_regular_file()) tree.files.push_back(read_source_file(root, entry.path()));
    }
  }
  std::sort(tree.files.begin(), tree.files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  std::sort(tree.empty_folders.begin(), tree.empty_folders.end());
  return tree;
}

}  // namespace cdfr::rooms
