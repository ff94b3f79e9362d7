/// A gzip file unpacked to a temporary one.
#pragma once

#include <filesystem>

namespace cdfr::bench {

class Unpacked {
 public:
  /// An empty file if `packed` cannot be read, so that reading it as a mesh says what is wrong.
  explicit Unpacked(const std::filesystem::path& packed);
  Unpacked(const Unpacked&) = delete;
  Unpacked& operator=(const Unpacked&) = delete;
  ~Unpacked();

  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cdfr::bench
