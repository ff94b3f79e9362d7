/// A grid's samples along the three axes: where each lies in the octree's lattice follows from its axes one
/// by one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cdfr/field/grid.h"
#include "octree/leaf_index.h"

namespace cdfr {

/// Samples first .. end - 1.
struct Stretch {
  std::uint32_t first = 0, end = 0;
  std::uint32_t size() const noexcept { return end - first; }
};

using Stretches = std::array<Stretch, 3>;

inline std::size_t count_of(const Stretches& s) noexcept {
  return std::size_t{s[0].size()} * s[1].size() * s[2].size();
}

class GridAxes {
 public:
  GridAxes(const Grid& grid, const LeafIndex& index);

  /// In the half-open brick.
  bool contains(const std::array<std::uint32_t, 3>& sample) const noexcept {
    return axes_[0][sample[0]].in_brick && axes_[1][sample[1]].in_brick && axes_[2][sample[2]].in_brick;
  }
  /// As a query has it, without dust.
  Vec3 point(const std::array<std::uint32_t, 3>& sample) const noexcept {
    return {axes_[0][sample[0]].x, axes_[1][sample[1]].x, axes_[2][sample[2]].x};
  }
  LatticePoint place(const std::array<std::uint32_t, 3>& sample) const noexcept {
    const Coordinate &x = axes_[0][sample[0]], &y = axes_[1][sample[1]], &z = axes_[2][sample[2]];
    return {{x.at, y.at, z.at}, {x.place, y.place, z.place}};
  }
  double at(int axis, std::uint32_t i) const noexcept { return axes_[axis][i].at; }
  /// Are samples i and k of an axis in the brick, in the same cell of 2^up places?
  bool share_cell(int axis, std::uint32_t i, std::uint32_t k, std::uint32_t up) const noexcept {
    const Coordinate &a = axes_[axis][i], &b = axes_[axis][k];
    return a.in_brick && b.in_brick && a.place >> up == b.place >> up;
  }
  /// Where the samples from i on that share its cell end, at most `end`. Coordinates never turn back along an
  /// axis, so a cell's samples are neighbours.
  std::uint32_t end_of_cell(int axis, std::uint32_t i, std::uint32_t up, std::uint32_t end) const noexcept {
    std::uint32_t k = i + 1;
    while (k < end && share_cell(axis, i, k, up)) ++k;
    return k;
  }

 private:
  struct Coordinate {
    double x, at;
    std::uint32_t place;
    bool in_brick;
  };
  std::array<std::vector<Coordinate>, 3> axes_;
};

}  // namespace cdfr
