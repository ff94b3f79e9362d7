/// A block of a file when it is first read: its checksum, and that no number in it leads out of the arrays.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/guarded_map.h"
#include "store/format.h"

namespace cdfr {

/// Thread safe. What the numbers mean, beyond that a query may follow them, is for check_field (check.h).
class FileCheck final : public BlockCheck {
 public:
  /// Of a file whose head and directory are good. The bytes must outlive this.
  FileCheck(std::span<const std::byte> bytes, const format::Counts& counts);

  bool good(std::size_t first, std::size_t end) const noexcept override;
  void fill(std::size_t first, std::size_t end, std::byte* into) const noexcept override;

  /// The first block whose checksum or numbers are bad; the file's size if there is none. O(size).
  std::size_t first_bad() const noexcept;
  /// "entries element 17 to records element 4" for the block that begins at that byte.
  std::string place_text(std::size_t where) const;

 private:
  bool sums_up(std::size_t first, std::size_t end) const noexcept;
  template <class T>
  const T* elements(format::Section section) const noexcept {
    return reinterpret_cast<const T*>(bytes_.data() + places_.at[section]);
  }
  bool in_bounds(format::Section section, std::uint64_t first, std::uint64_t end) const noexcept;

  std::span<const std::byte> bytes_;
  format::Counts counts_;
  format::Places places_;
};

}  // namespace cdfr
