/// A regular file, open for reading.
#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <filesystem>

#include "cdfr/core/result.h"

namespace cdfr {

/// Move-only; closes itself.
class RegularFile {
 public:
  /// Error: file_open for what is missing, no regular file (directory, FIFO, device, socket) or larger than
  /// the address space. Never blocks.
  static Result<RegularFile> open(const std::filesystem::path& path);

  RegularFile(RegularFile&& other) noexcept;
  RegularFile& operator=(RegularFile&& other) noexcept;
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;
  ~RegularFile();

  int descriptor() const noexcept { return descriptor_; }
  std::size_t size() const noexcept { return static_cast<std::size_t>(status_.st_size); }
  /// When it was opened.
  const struct stat& status() const noexcept { return status_; }

  /// file_open with the system's reason for its last failure.
  static Error error(const char* what);

 private:
  explicit RegularFile(int descriptor) noexcept : descriptor_(descriptor) {}

  int descriptor_ = -1;
  struct stat status_ {};
};

}  // namespace cdfr
