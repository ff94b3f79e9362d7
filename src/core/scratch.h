/// Memory for arrays that may be larger than what the work is allowed to hold: files that the kernel pages in
/// and out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

#include "cdfr/core/result.h"

namespace cdfr {

/// Blocks of memory, the large ones as maps of files without a name in one folder: they take disk and no
/// anonymous memory, and are gone with the process, however it ends. Thread safe.
class Scratch {
 public:
  /// Smaller blocks come from the heap.
  static constexpr std::size_t large = std::size_t{1} << 20;

  /// Precondition: the folder exists, and may be written for as long as this lives.
  explicit Scratch(std::filesystem::path folder);

  /// Throws std::bad_alloc if the disk is full or the folder may not be written, as a heap does that is
  /// exhausted. Disk is claimed at once, so that no later access fails.
  void* allocate(std::size_t bytes) const;
  void release(void* block, std::size_t bytes) const noexcept;

 private:
  std::filesystem::path folder_;
};

/// Allocates from a Scratch, or from the heap if it has none. It goes along when a vector is moved or
/// swapped; a copy of a vector lies where its origin does. The scratch must outlive the vectors.
template <class T>
class LargeAllocator {
 public:
  using value_type = T;
  using propagate_on_container_copy_assignment = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  LargeAllocator(const Scratch* scratch = nullptr) noexcept : scratch_(scratch) {}
  template <class U>
  LargeAllocator(const LargeAllocator<U>& other) noexcept : scratch_(other.scratch()) {}

  T* allocate(std::size_t count) {
    if (scratch_ == nullptr) return std::allocator<T>().allocate(count);
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(scratch_->allocate(count * sizeof(T)));
  }
  void deallocate(T* block, std::size_t count) noexcept {
    if (scratch_ == nullptr) return std::allocator<T>().deallocate(block, count);
    scratch_->release(block, count * sizeof(T));
  }

  const Scratch* scratch() const noexcept { return scratch_; }
  friend bool operator==(const LargeAllocator& a, const LargeAllocator& b) noexcept {
    return a.scratch_ == b.scratch_;
  }

 private:
  const Scratch* scratch_;
};

/// A vector that lies where it was told to: Large<T> v(scratch), nullptr for the heap.
template <class T>
using Large = std::vector<T, LargeAllocator<T>>;

}  // namespace cdfr
