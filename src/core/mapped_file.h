/// A regular file as a span of bytes: the kernel pages it in and out, so that a huge file costs no memory of
/// ours.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "cdfr/core/result.h"

namespace cdfr {

/// Move-only. Not promised: what is read if another process writes to the file meanwhile; if it is cut short,
/// touching the lost pages ends the process (SIGBUS), as with every memory map.
class MappedFile {
 public:
  /// Error: file_open for what is missing or no regular file (directory, FIFO, device, socket). Never blocks.
  static Result<MappedFile> open(const std::filesystem::path& path);

  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile();

  std::span<const std::byte> bytes() const noexcept { return bytes_; }

 private:
  explicit MappedFile(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}
  void close() noexcept;
  std::span<const std::byte> bytes_;
};

}  // namespace cdfr
