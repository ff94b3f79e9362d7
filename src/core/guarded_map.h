/// A mapped file whose blocks are looked at when they are first read, wherever that is: the kernel tells.
///
/// The file is mapped twice. One map may always be read and is for checking alone. The other one, which is
/// given out, may not: reading a block of it for the first time faults, the fault's handler has the block
/// checked, and from then on it may be read at full speed. A block that is bad, or that is gone because the
/// file was cut short meanwhile, is replaced by harmless values and the map has failed, for good.
///
/// The handler is for SIGSEGV and SIGBUS, is installed with the first map and stays. Faults that are not in a
/// map go on to the handlers that were there before. A program that installs its own later must do likewise.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "cdfr/core/result.h"

namespace cdfr {

/// Says what a block should hold. Both are called from a signal's handler: no locks, no allocation, and of
/// the file they read the open map alone, in which a lost page reads as zeros.
class BlockCheck {
 public:
  virtual ~BlockCheck() = default;
  /// Are the bytes [first, end) of the file what they should be?
  virtual bool good(std::size_t first, std::size_t end) const noexcept = 0;
  /// Values for them that lead nobody astray. `into` is all of [first, end), zero.
  virtual void fill(std::size_t first, std::size_t end, std::byte* into) const noexcept = 0;
};

/// Thread safe.
class GuardedMap {
 public:
  /// Bytes of a block: a multiple of any page's size.
  static constexpr std::size_t block_size = std::size_t{1} << 17;

  /// Errors: file_open, as MappedFile; also if more than a thousand maps are open at once.
  static Result<std::shared_ptr<GuardedMap>> open(const std::filesystem::path& path);
  GuardedMap(const GuardedMap&) = delete;
  GuardedMap& operator=(const GuardedMap&) = delete;
  ~GuardedMap();

  /// For checking. A page that the file lost since reads as zeros, and the map has failed.
  std::span<const std::byte> open_bytes() const noexcept { return {open_, size_}; }
  /// For use, once there is a check. Precondition: none was set before; it lives as long as this.
  std::span<const std::byte> guard(const BlockCheck& check) noexcept;

  bool failed() const noexcept { return failed_.load(std::memory_order_relaxed); }
  /// Error: what has failed, and where; or that the file at the path is not the one that was opened, or not
  /// as it was (size, time of change). One call to the system.
  Result<void> status() const;

  /// For the handler. True if the access may be tried again.
  bool handle_fault(const std::byte* at, bool gone) noexcept;

 private:
  GuardedMap() = default;
  void fail(std::size_t where) noexcept;
  void replace(std::byte* base, std::size_t first, std::size_t end) noexcept;

  std::filesystem::path path_;
  std::byte* open_ = nullptr;
  std::byte* guarded_ = nullptr;
  std::size_t size_ = 0;
  std::uint64_t device_ = 0, inode_ = 0;
  std::int64_t changed_[2] = {0, 0};
  const BlockCheck* check_ = nullptr;
  std::unique_ptr<std::atomic<std::uint64_t>[]> read_;  ///< a bit a block: it may be read
  std::size_t slot_ = 0;
  std::atomic<bool> failed_{false};
  std::atomic<std::size_t> where_{0};
};

}  // namespace cdfr
