#include "field/deepest_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "field/block_sides.h"
#include "field/distance_above.h"
#include "field/query.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

double rounding_in(const Box& box) noexcept {
  return point_rounding(std::max(largest_magnitude(box.lo), largest_magnitude(box.hi)));
}

}  // namespace

DeepestSearch::DeepestSearch(const FieldData& field, const Goal& goal, Progress& progress)
    : field_(field), goal_(goal), progress_(progress), rounding_(rounding_in(field.bounds())) {
  best_.depth = goal.above;
}

DeepestSearch::Looked DeepestSearch::look(const Cube& cube) const noexcept {
  Looked looked{cube, 0, -signed_distance(field_, cube.centre())};
  const double radius = cube.half_diagonal() + rounding_;
  const bool jumps = !field_.winding.empty();
  const double height = jumps ? std::fabs(looked.depth) : looked.depth;
  looked.bound = height + radius;
  // Where the sign jumps, the other side goes on with distances as large.
  if (jumps && looked.depth < -radius && side_of_free_ball(field_, cube.centre(), radius) == Side::outside)
    looked.bound = 0;
  return looked;
}

Deepest DeepestSearch::run(std::span<const Looked> cubes) {
  for (const Looked& cube : cubes) better(cube);
  for (const Looked& cube : cubes) keep(cube);
  while (!open_.empty() && !is_done() && progress_.poll()) {
    const Looked cube = open_.top();
    open_.pop();
    if (cube.bound > best_.depth + goal_.error) {
      halve(cube);
    } else {
      close(cube);
    }
  }
  best_.error = std::max(rounding_, closed_ - best_.depth);
  return best_;
}

bool DeepestSearch::is_done() const noexcept { return is_open_ || (goal_.any && best_.depth > goal_.above); }

void DeepestSearch::better(const Looked& looked) {
  if (!(looked.depth > best_.depth)) return;
  best_.depth = looked.depth;
  best_.point = looked.cube.centre();
}

/// The dear bound only where the cheap one does not rule the cube out.
void DeepestSearch::keep(Looked at) {
  if (!(at.bound > best_.depth + goal_.error)) return close(at);
  at.bound = std::min(at.bound, distance_above(field_, at.cube.lo, at.cube.size) + rounding_);
  at.number = next_++;
  at.rank = std::floor(at.bound / goal_.error);
  if (!(at.bound > best_.depth + goal_.error)) return close(at);
  open_.push(at);
}

void DeepestSearch::close(const Looked& at) noexcept { closed_ = std::max(closed_, at.bound); }

/// Halves no further than where coordinates end.
void DeepestSearch::halve(const Looked& at) {
  is_open_ = ++halved_ > goal_.most;
  if (at.cube.size / 2 <= rounding_ || is_open_) return close(at);
  std::array<Looked, 8> octants;
  for (int child = 0; child < 8; ++child) {
    octants[static_cast<std::size_t>(child)] = look(at.cube.octant(child));
    better(octants[static_cast<std::size_t>(child)]);
  }
  for (Looked& octant : octants) {
    octant.bound = std::min(octant.bound, at.bound);
    keep(octant);
  }
}

}  // namespace cdfr
