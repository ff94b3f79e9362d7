#include "rooms/include_rules.h"

#include <array>
#include <optional>
#include <utility>

namespace cdfr::rooms {
namespace {

// Rooms of equal rank do not see each other. The umbrella headers (cdfr.h, eigen.h) see every room and no
// room sees them.
constexpr std::array<std::pair<std::string_view, int>, 15> ranks{{{"core", 0},
                                                                  {"geometry", 1},
                                                                  {"mesh", 2},
                                                                  {"parts", 3},
                                                                  {"octree", 4},
                                                                  {"field", 5},
                                                                  {"contour", 6},
                                                                  {"analysis", 6},
                                                                  {"store", 6},
                                                                  {"export", 6},
                                                                  {"render", 6},
                                                                  {"reference", 6},
                                                                  {"distributed", 6},
                                                                  {"c", 7},
                                                                  {"umbrella", 8}}};

std::optional<int> rank_of(std::string_view room) {
  for (const auto& [name, rank] : ranks) {
    if (name == room) return rank;
  }
  return std::nullopt;
}

std::string first_part(const std::string& path) { return path.substr(0, path.find('/')); }

/// Room of a public header, given what follows "cdfr/".
std::string public_room(const std::string& rest) {
  if (rest.find('/') != std::string::npos) return first_part(rest);
  if (rest == "version.h") return "core";
  if (rest == "c.h") return "c";
  return "umbrella";
}

/// Room of a file of the library; nothing for files that are in no room.
std::optional<std::string> own_room(const SourceFile& file) {
  if (file.part(0) == "include" && file.part(1) == "cdfr") return public_room(file.path.substr(13));
  if (file.part(0) == "src" && !file.part(2).empty()) return file.part(1);
  return std::nullopt;
}

bool is_public(const Include& include) { return include.path.starts_with("cdfr/"); }

std::string check_library(const SourceTree& tree, const SourceFile& file, const Include& include) {
  const bool in_header = file.part(0) == "include";
  std::string room;
  if (is_public(include)) {
    room = public_room(include.path.substr(5));
    if (!tree.has("include/" + include.path)) return "no such public header";
  } else {
    if (!include.quoted) return {};
    if (in_header) return "a public header includes what is not public";
    room = first_part(include.path);
    if (!tree.has("src/" + include.path)) return "not written relative to src, or no such file";
  }
  const std::string own = own_room(file).value_or("");
  const std::optional<int> from = rank_of(own);
  const std::optional<int> to = rank_of(room);
  if (!from) return "file in no room of the design";
  if (!to) return "include of no room of the design";
  if (room != own && *to >= *from) return own + " must not see " + room;
  return {};
}

/// tools and bench: public headers and files of their own.
std::string check_program(const SourceTree& tree, const SourceFile& file, const Include& include) {
  if (is_public(include) && tree.has("include/" + include.path)) return {};
  if (!include.quoted) return {};
  const std::string folder = file.path.substr(0, file.path.rfind('/') + 1);
  if (tree.has(folder + include.path) || tree.has(file.part(0) + "/" + include.path)) return {};
  return "only public headers and its own files may be included";
}

std::string check_test(const SourceTree& tree, const SourceFile& file, const Include& include) {
  if (is_public(include)) return tree.has("include/" + include.path) ? "" : "no such public header";
  if (!include.quoted) return {};
  const std::string folder = file.path.substr(0, file.path.rfind('/') + 1);
  if (tree.has(folder + include.path) || tree.has("tests/" + include.path)) return {};
  if (!tree.has("src/" + include.path)) return "no such file";
  const std::string own = file.part(1), room = first_part(include.path);
  const std::optional<int> from = rank_of(own);
  const std::optional<int> to = rank_of(room);
  if (room == own || (from && to && *to < *from)) return {};
  return "a test sees public headers and what its own room sees, not " + room;
}

std::string check(const SourceTree& tree, const SourceFile& file, const Include& include) {
  const std::string top = file.part(0);
  if (top == "src" || top == "include") return check_library(tree, file, include);
  if (top == "tests") return check_test(tree, file, include);
  return check_program(tree, file, include);
}

}  // namespace

std::vector<std::string> include_violations(const SourceTree& tree) {
  std::vector<std::string> violations;
  for (const SourceFile& file : tree.files) {
    if (!file.has_extension(".h") && !file.has_extension(".cpp")) continue;
    for (const Include& include : file.includes) {
      const std::string what = check(tree, file, include);
      if (what.empty()) continue;
      violations.push_back(file.path + ":" + std::to_string(include.line) + ": " + include.path + ": " +
                           what);
    }
  }
  return violations;
}

}  // namespace cdfr::rooms
