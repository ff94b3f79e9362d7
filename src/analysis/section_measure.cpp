#include "analysis/section_measure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/cell_index.h"
#include "analysis/cut_cube.h"

namespace cdfr {
namespace {

Vec3 way_of(const HeavyCell& cell) noexcept { return {cell.gradient[0], cell.gradient[1], cell.gradient[2]}; }

/// How far the half-space offset + way.y >= 0 reaches in the cube [-half, half]^3 along an axis, to each
/// side.
struct Reach {
  double lo, hi;
};
Reach reach_along(double offset, const HeavyCell& cell, std::size_t axis, double half) noexcept {
  const double way = cell.gradient[axis];
  const double others = cell.swing(half) - half * std::fabs(way);
  // At y the best of the rest is offset + others + way y.
  const double most = offset + others;
  Reach reach{-half, half};
  if (way > 0) reach.lo = std::max(reach.lo, -most / way);
  if (way < 0) reach.hi = std::min(reach.hi, -most / way);
  return reach;
}

void make_unique(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

void SectionMeasure::add(const CoreRule& rule, const HeavyCell& cell) {
  const double half = half_of(cell);
  ++cells_;
  extend(cell, half);
  deepest_ = std::max(deepest_, rule.core_point(cell, half).over);
  if (cell.is_inner(half)) {
    sure_ += 8 * half * half * half;
    possible_ += 8 * half * half * half;
    return;
  }
  const Vec3 way = way_of(cell);
  const double low = double{cell.over} - double{cell.below}, high = double{cell.over} + double{cell.above};
  const CubeCut sure = cut_cube(way, low, half), possible = cut_cube(way, high, half);
  // A plane along a face of the cube is the surface of this cell: the one beyond the face holds nothing
  // deeper.
  const double face = cell.swing(half), offset = (low + high) / 2, hair = 0x1p-20 * half;
  const bool on_face = std::fabs(offset - face) < hair;
  const CubeCut middle = cut_cube(way, on_face ? face - hair : offset, half);
  sure_ += sure.volume;
  possible_ += possible.volume;
  cut_ += 8 * half * half * half;
  area_ += middle.area;
  area_low_ += sure.area;
  area_high_ += possible.area;
  // A surface between two planes that far apart may be tilted by about that over the edge.
  const double slope = (high - low) / (2 * half);
  tilt_ += middle.area * std::min(1.0, slope * slope / 2);
}

void SectionMeasure::add_doubtful(const HeavyCell& cell) {
  const double half = half_of(cell);
  possible_ += cut_cube(way_of(cell), double{cell.over} + double{cell.above}, half).volume;
  cut_ += 8 * half * half * half;
}

void SectionMeasure::add_triangle(std::uint32_t number) {
  if (triangles_.size() >= 2 * sorted_ + 64) {
    make_unique(triangles_);
    sorted_ = triangles_.size();
  }
  triangles_.push_back(number);
}

void SectionMeasure::extend(const HeavyCell& cell, double half) {
  const Cell at = cell_of(cell.key);
  const double high = double{cell.over} + double{cell.above};
  double* const lo[3] = {&box_.lo.x, &box_.lo.y, &box_.lo.z};
  double* const hi[3] = {&box_.hi.x, &box_.hi.y, &box_.hi.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double centre = (2.0 * at.place[axis] + 1) * half;
    const Reach reach = reach_along(high, cell, axis, half);
    *lo[axis] = std::min(*lo[axis], centre + reach.lo);
    *hi[axis] = std::max(*hi[axis], centre + reach.hi);
  }
}

Section SectionMeasure::section(const Lattice& lattice) {
  make_unique(triangles_);
  Section section;
  const double edge = lattice.edge, cube = edge * edge * edge;
  section.volume = (sure_ + possible_) / 2 * cube;
  // cut_cube's own error, and what sums round by.
  section.volume_error = ((possible_ - sure_) / 2 + cut_ * 0x1p-27 + possible_ * 0x1p-30) * cube;
  section.area = area_ * edge * edge;
  section.area_error = (tilt_ + std::fabs(area_high_ - area_low_) / 2) * edge * edge;
  const auto placed = [&](const Vec3& v) {
    return Vec3{lattice.origin.x + v.x * edge, lattice.origin.y + v.y * edge, lattice.origin.z + v.z * edge};
  };
  section.box = {placed(box_.lo), placed(box_.hi)};
  section.cells = cells_;
  section.triangles = std::move(triangles_);
  return section;
}

}  // namespace cdfr
