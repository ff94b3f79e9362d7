#include "field/deepest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <vector>

#include "core/parallel.h"
#include "field/block_sides.h"
#include "field/distance_above.h"
#include "field/leaves.h"
#include "field/query.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

struct Cube {
  Vec3 lo;
  double size = 0;
  double bound = 0;          ///< no point of it is deeper
  std::uint64_t number = 0;  ///< in the order they came up

  Vec3 centre() const noexcept { return {lo.x + size / 2, lo.y + size / 2, lo.z + size / 2}; }
  double half_diagonal() const noexcept { return 0.8660254037844387 * size; }
  double rank = 0;  ///< the bound in whole errors
  /// Of a heap: the largest rank on top, of those the smallest cube. Along a plate's middle all bounds are
  /// the same but for rounding; one has to be looked into to the end before the others.
  friend bool operator<(const Cube& a, const Cube& b) noexcept {
    if (a.rank != b.rank) return a.rank < b.rank;
    return a.size != b.size ? a.size > b.size : a.number > b.number;
  }
};

/// A centre that was looked at.
struct Looked {
  Cube cube;
  double depth = 0;  ///< of the centre; not above 0 outside
};

class Search {
 public:
  Search(const FieldData& field, double error, Progress& progress)
      : field_(field), error_(error), progress_(progress), rounding_(rounding_of(field)) {}

  Result<Deepest> run() {
    progress_.phase(0, 0.5, static_cast<double>(field_.tree.block_count()));
    for (const std::vector<Looked>& block : looked_leaves()) {
      for (const Looked& leaf : block) better(leaf);
      leaves_.insert(leaves_.end(), block.begin(), block.end());
    }
    for (const Looked& leaf : leaves_) keep(leaf.cube);
    leaves_.clear();
    while (!open_.empty() && progress_.poll()) {
      const Cube cube = open_.top();
      open_.pop();
      if (cube.bound > best_.depth + error_) {
        halve(cube);
      } else {
        close(cube);
      }
    }
    if (field_.failed()) return field_.status().error();
    if (progress_.cancelled()) return Progress::error();
    best_.error = std::max(rounding_, closed_ - best_.depth);
    return best_;
  }

 private:
  /// 16 ulp at the largest coordinate: of a distance and of a bound's arithmetic.
  static double rounding_of(const FieldData& field) noexcept {
    const Box& box = field.bounds();
    const double largest = std::max(largest_magnitude(box.lo), largest_magnitude(box.hi));
    return 16 * std::ldexp(1.0, std::ilogb(largest) - 52);
  }

  Looked look(const Vec3& lo, double size) noexcept {
    Looked looked;
    looked.cube.lo = lo;
    looked.cube.size = size;
    looked.depth = -signed_distance(field_, looked.cube.centre());
    const double radius = looked.cube.half_diagonal() + rounding_;
    const bool jumps = !field_.winding.empty();
    const double height = jumps ? std::fabs(looked.depth) : looked.depth;
    looked.cube.bound = height + radius;
    // Where the sign jumps, the other side goes on with distances as large.
    if (jumps && looked.depth < -radius &&
        side_of_free_ball(field_, looked.cube.centre(), radius) == Side::outside)
      looked.cube.bound = 0;
    return looked;
  }

  std::vector<std::vector<Looked>> looked_leaves() {
    std::vector<std::vector<Looked>> looked(field_.tree.block_count());
    for_chunks(looked.size(), 1, [&](std::size_t i, std::size_t) {
      const Block block = field_.tree.block(i);
      for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
        if (block.leaves[number].side() == Side::outside || !progress_.poll()) return;
        const Lattice& lattice = field_.tree.lattice;
        looked[i].push_back(look(lattice.box(cell).lo, lattice.size(cell.level)));
      });
      progress_.step();
    });
    return looked;
  }

  void better(const Looked& at) {
    if (!(at.depth > best_.depth)) return;
    best_.depth = at.depth;
    best_.point = at.cube.centre();
  }

  /// The dear bound only where the cheap one does not rule the cube out.
  void keep(Cube cube) {
    if (!(cube.bound > best_.depth + error_)) return close(cube);
    cube.bound = std::min(cube.bound, distance_above(field_, cube.lo, cube.size) + rounding_);
    cube.number = next_++;
    cube.rank = std::floor(cube.bound / error_);
    if (!(cube.bound > best_.depth + error_)) return close(cube);
    open_.push(cube);
  }

  void close(const Cube& cube) noexcept { closed_ = std::max(closed_, cube.bound); }

  /// Halves no further than where coordinates end.
  void halve(const Cube& cube) {
    const double half = cube.size / 2;
    if (half <= rounding_) return close(cube);
    std::array<Looked, 8> octants;
    for (std::size_t child = 0; child < 8; ++child) {
      octants[child] = look({cube.lo.x + (child & 1U ? half : 0), cube.lo.y + (child & 2U ? half : 0),
                             cube.lo.z + (child & 4U ? half : 0)},
                            half);
      better(octants[child]);
    }
    for (Looked& octant : octants) {
      octant.cube.bound = std::min(octant.cube.bound, cube.bound);
      keep(octant.cube);
    }
  }

  const FieldData& field_;
  double error_;
  Progress& progress_;
  double rounding_;
  Deepest best_;
  std::vector<Looked> leaves_;
  std::priority_queue<Cube> open_;
  std::uint64_t next_ = 0;
  double closed_ = 0;  ///< largest bound of a cube that is not looked into any more
};

}  // namespace

Result<Deepest> deepest_point(const FieldData& field, double error, Progress& progress) {
  return Search(field, error, progress).run();
}

}  // namespace cdfr
