/// Cells in Morton order, found by their places, and how they touch.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/heavy_cell.h"
#include "octree/key.h"

namespace cdfr {

/// A cell's first place on the deepest level in Morton order, without the key's sentinel: 63 bits.
struct Span {
  std::uint64_t first = 0;
  int level = 0;

  static Span of(std::uint64_t key) noexcept {
    const int levels = (63 - std::countl_zero(key)) / 3;
    const int up = virtual_levels + deepest_level - levels;
    return {(key ^ (std::uint64_t{1} << (3 * levels))) << (3 * up), levels - virtual_levels};
  }
  /// Places on the deepest level that it covers.
  std::uint64_t size() const noexcept { return std::uint64_t{1} << (3 * (deepest_level - level)); }
};

/// In edges of the lattice, the centre from its origin.
double half_of(const HeavyCell& cell) noexcept;
Vec3 centre_of(const HeavyCell& cell) noexcept;

enum class Touch : std::uint8_t {
  none,  ///< no point of the face that they share is deeper than T
  possible,
  certain  ///< a way from one to the other is all deeper than T
};

/// Of two cells that share a face, the first one's, no larger than the second one's.
Touch touch_of(const CoreRule& rule, const HeavyCell& small, const HeavyCell& large) noexcept;
/// Is the way between the core points of any two cells all deeper than T?
bool cores_join(const CoreRule& rule, const HeavyCell& a, const HeavyCell& b) noexcept;
bool has_core(const CoreRule& rule, const HeavyCell& cell) noexcept;

class CellIndex {
 public:
  static constexpr std::size_t none = ~std::size_t{0};

  /// The cells are borrowed, disjoint, in Morton order.
  explicit CellIndex(std::span<const HeavyCell> cells);

  /// The cell that holds that place of the deepest level, or none.
  std::size_t at(std::uint64_t place) const noexcept;

  /// Does any cell begin in that cube of space?
  bool is_any_in(const Span& cube) const noexcept;
  /// The first place of the neighbour of the same size on that side. False at the end of the virtual cube.
  static bool beside(const Span& own, int axis, bool up, std::uint64_t& place) noexcept;

  /// meet(i, j) for cells j that share a face with cell i and are no smaller; of two equal ones only the
  /// lower one meets the upper one. So each pair meets once when all cells have had their turn.
  template <class Meet>
  void for_each_neighbour(std::size_t i, Meet meet) const {
    const Span own = Span::of(cells_[i].key);
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool up : {false, true}) {
        std::uint64_t place = 0;
        if (!beside(own, axis, up, place)) continue;
        const std::size_t j = at(place);
        if (j == none) continue;
        // The finer one finds the coarser one; of equals the lower one finds the upper one.
        const int level = Span::of(cells_[j].key).level;
        if (level < own.level || (level == own.level && up)) meet(i, j);
      }
    }
  }

 private:
  std::size_t end_at(std::uint64_t place) const noexcept;

  std::span<const HeavyCell> cells_;
  std::uint64_t first_ = 0;
  int shift_ = 0;                      ///< places in a bucket, as a power of two
  std::vector<std::uint32_t> bucket_;  ///< the first cell in it or after it
};

}  // namespace cdfr
