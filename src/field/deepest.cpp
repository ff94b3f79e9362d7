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
#include "geometry/cube.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

struct BoundedCube {
  Cube cube;
  double bound = 0;          ///< no point of it is deeper
  std::uint64_t number = 0;  ///< in the order they came up
  double rank = 0;           ///< the bound in whole errors
  /// Of a heap: the largest rank on top, of those the smallest cube. Along a plate's middle all bounds are
  /// the same but for rounding; one has to be looked into to the end before the others.
  friend bool operator<(const BoundedCube& a, const BoundedCube& b) noexcept {
    if (a.rank != b.rank) return a.rank < b.rank;
    return a.cube.size != b.cube.size ? a.cube.size > b.cube.size : a.number > b.number;
  }
};

/// A centre that was looked at.
struct Looked {
  BoundedCube at;
  double depth = 0;  ///< of the centre; not above 0 outside
};

double rounding_in(const Box& box) noexcept {
  return point_rounding(std::max(largest_magnitude(box.lo), largest_magnitude(box.hi)));
}

class DeepestSearch {
 public:
  DeepestSearch(const FieldData& field, double error, Progress& progress)
      : field_(field), error_(error), progress_(progress), rounding_(rounding_in(field.bounds())) {}

  void add_leaves() {
    progress_.phase(0, 0.5, static_cast<double>(field_.tree.block_count()));
    for (const std::vector<Looked>& block : looked_leaves()) {
      for (const Looked& leaf : block) better(leaf);
      first_.insert(first_.end(), block.begin(), block.end());
    }
  }

  void add(const Cube& cube) {
    first_.push_back(look(cube));
    better(first_.back());
  }

  Result<Deepest> run() {
    for (const Looked& looked : first_) keep(looked.at);
    first_.clear();
    while (!open_.empty() && progress_.poll()) {
      const BoundedCube cube = open_.top();
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
  Looked look(const Cube& cube) noexcept {
    Looked looked{{cube}, -signed_distance(field_, cube.centre())};
    const double radius = cube.half_diagonal() + rounding_;
    const bool jumps = !field_.winding.empty();
    const double height = jumps ? std::fabs(looked.depth) : looked.depth;
    looked.at.bound = height + radius;
    // Where the sign jumps, the other side goes on with distances as large.
    if (jumps && looked.depth < -radius && side_of_free_ball(field_, cube.centre(), radius) == Side::outside)
      looked.at.bound = 0;
    return looked;
  }

  std::vector<std::vector<Looked>> looked_leaves() {
    std::vector<std::vector<Looked>> looked(field_.tree.block_count());
    for_chunks(looked.size(), 1, [&](std::size_t i, std::size_t) {
      const Block block = field_.tree.block(i);
      for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
        if (block.leaves[number].side() == Side::outside || !progress_.poll()) return;
        const Lattice& lattice = field_.tree.lattice;
        looked[i].push_back(look({lattice.box(cell).lo, lattice.size(cell.level)}));
      });
      progress_.step();
    });
    return looked;
  }

  void better(const Looked& looked) {
    if (!(looked.depth > best_.depth)) return;
    best_.depth = looked.depth;
    best_.point = looked.at.cube.centre();
  }

  /// The dear bound only where the cheap one does not rule the cube out.
  void keep(BoundedCube at) {
    if (!(at.bound > best_.depth + error_)) return close(at);
    at.bound = std::min(at.bound, distance_above(field_, at.cube.lo, at.cube.size) + rounding_);
    at.number = next_++;
    at.rank = std::floor(at.bound / error_);
    if (!(at.bound > best_.depth + error_)) return close(at);
    open_.push(at);
  }

  void close(const BoundedCube& at) noexcept { closed_ = std::max(closed_, at.bound); }

  /// Halves no further than where coordinates end.
  void halve(const BoundedCube& at) {
    if (at.cube.size / 2 <= rounding_) return close(at);
    std::array<Looked, 8> octants;
    for (int child = 0; child < 8; ++child) {
      octants[static_cast<std::size_t>(child)] = look(at.cube.octant(child));
      better(octants[static_cast<std::size_t>(child)]);
    }
    for (Looked& octant : octants) {
      octant.at.bound = std::min(octant.at.bound, at.bound);
      keep(octant.at);
    }
  }

  const FieldData& field_;
  double error_;
  Progress& progress_;
  double rounding_;
  Deepest best_;
  std::vector<Looked> first_;
  std::priority_queue<BoundedCube> open_;
  std::uint64_t next_ = 0;
  double closed_ = 0;  ///< largest bound of a cube that is not looked into any more
};

}  // namespace

Result<Deepest> deepest_point(const FieldData& field, double error, Progress& progress) {
  DeepestSearch search(field, error, progress);
  search.add_leaves();
  return search.run();
}

Result<Deepest> deepest_among(const FieldData& field, std::span<const Cube> cubes, double error,
                              Progress& progress) {
  DeepestSearch search(field, error, progress);
  for (const Cube& cube : cubes) search.add(cube);
  return search.run();
}

}  // namespace cdfr
