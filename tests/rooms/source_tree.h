/// The project's source tree as the rules about it see it: its files and their #include lines.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cdfr::rooms {

struct Include {
  std::size_t line = 0;
  std::string path;  ///< as written between the quotes or brackets
  bool quoted = true;
};

struct SourceFile {
  std::string path;  ///< relative to the root, with '/'
  std::size_t lines = 0;
  std::string text;
  std::vector<Include> includes;

  /// Part k of the path; empty beyond its end.
  std::string part(std::size_t k) const;
  std::string name() const;
  bool has_extension(std::string_view extension) const;
};

struct SourceTree {
  std::filesystem::path root;
  std::vector<SourceFile> files;  ///< those in src, include, tools, bench and tests, sorted
  std::vector<std::string> empty_folders;

  bool has(const std::string& path) const;
};

SourceTree read_source_tree(const std::filesystem::path& root);

}  // namespace cdfr::rooms
