/// A small project that keeps every rule, made in a temporary folder, for showing that the rules notice a
/// breach.
#pragma once

#include <filesystem>
#include <string>

namespace cdfr::rooms {

/// Removed when it goes.
class MadeTree {
 public:
  MadeTree();
  ~MadeTree();
  MadeTree(const MadeTree&) = delete;
  MadeTree& operator=(const MadeTree&) = delete;

  const std::filesystem::path& root() const { return root_; }
  void write(const std::string& path, const std::string& text) const;
  void make_folder(const std::string& path) const;

 private:
  std::filesystem::path root_;
};

}  // namespace cdfr::rooms
