/// A file that is written whole or not at all (promise 6).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "cdfr/core/result.h"

namespace cdfr {

/// Bytes go to a temporary file in the target's directory; finish() puts it in the target's place in one
/// step. Until then, and after any error, what was at the target stays as it was, and the destructor removes
/// the temporary file.
///
/// All errors are Code::file_write with the system's reason; `where` is the byte that could not be written.
/// The first error is kept: every later call returns it again, so a caller may check only finish(). Not
/// thread safe.
class WholeFile {
 public:
  /// Refused now rather than after the work: a missing directory, a target that is there and is no regular
  /// file (directory, device, pipe, symbolic link), or may not be written. Permissions of the new file follow
  /// the umask.
  static Result<WholeFile> create(const std::filesystem::path& path);

  /// Appends. Buffered: small pieces are cheap.
  Result<void> write(std::span<const std::byte> bytes);
  Result<void> write(std::string_view text);

  /// Overwrites bytes that were appended before, such as a count known only at the end.
  /// Precondition: offset + bytes.size() <= size().
  Result<void> write_at(std::uint64_t offset, std::span<const std::byte> bytes);
  Result<void> write_at(std::uint64_t offset, std::string_view text);

  /// Bytes appended so far.
  std::uint64_t size() const noexcept;

  /// Writes what is buffered, syncs, renames over the target and syncs the directory. Call once, last. If
  /// only the sync of the directory fails, the error is returned though the new file is in place.
  Result<void> finish();

 private:
  struct State;
  struct Discard {
    void operator()(State* state) const noexcept;
  };
  explicit WholeFile(std::unique_ptr<State, Discard> state) noexcept : state_(std::move(state)) {}

  std::unique_ptr<State, Discard> state_;
};

}  // namespace cdfr
