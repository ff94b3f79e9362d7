#include "parts/delaunay.h"

#include <cstddef>

#include "cdfr/core/types.h"

namespace cdfr {
namespace {

/// Coordinates have 20 bits, so a determinant of the in-circle test has up to 82.
__extension__ using Wide = __int128;

constexpr std::size_t after(std::size_t i) noexcept { return (i + 1) % 3; }

}  // namespace

std::int64_t turn(PlanPoint a, PlanPoint b, PlanPoint c) noexcept {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Delaunay::Delaunay(PlanPoint far) : points_{{0, 0}, {far.x, 0}, far, {0, far.y}} {
  cells_.push_back({{0, 1, 2}, {no_index, 1, no_index}});
  cells_.push_back({{0, 2, 3}, {no_index, no_index, 0}});
}

/// The visibility walk; on a Delaunay triangulation it never turns in a circle.
std::uint32_t Delaunay::locate(PlanPoint point) const {
  auto here = static_cast<std::uint32_t>(cells_.size() - 1);
  while (true) {
    const Cell& cell = cells_[here];
    std::uint32_t next = here;
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanPoint from = points_[cell.corner[after(i)]];
      const PlanPoint to = points_[cell.corner[after(after(i))]];
      if (turn(from, to, point) < 0) {
        next = cell.beside[i];
        break;
      }
    }
    if (next == here || next == no_index) return here;
    here = next;
  }
}

bool Delaunay::circle_holds(const Cell& cell, PlanPoint point) const {
  std::array<Wide, 3> x{}, y{}, lift{};
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = points_[cell.corner[i]].x - point.x;
    y[i] = points_[cell.corner[i]].y - point.y;
    lift[i] = x[i] * x[i] + y[i] * y[i];
  }
  return lift[0] * (x[1] * y[2] - x[2] * y[1]) + lift[1] * (x[2] * y[0] - x[0] * y[2]) +
             lift[2] * (x[0] * y[1] - x[1] * y[0]) >
         0;
}

/// Removes the triangles whose circle holds the point and returns the border of what they covered. A side on
/// which the point lies, which only the rectangle's border can be, is left out: it falls in two.
std::vector<Delaunay::Side> Delaunay::open_hole(std::uint32_t start, PlanPoint point) {
  std::vector<std::uint32_t> hole{start};
  cells_[start].alive = false;
  std::vector<Side> sides;
  for (std::size_t at = 0; at < hole.size(); ++at) {
    const Cell cell = cells_[hole[at]];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t beyond = cell.beside[i];
      if (beyond != no_index) {
        if (!cells_[beyond].alive) continue;
        if (circle_holds(cells_[beyond], point)) {
          cells_[beyond].alive = false;
          hole.push_back(beyond);
          continue;
        }
      }
      const Side side{cell.corner[after(i)], cell.corner[after(after(i))], beyond};
      if (turn(points_[side.from], points_[side.to], point) != 0) sides.push_back(side);
    }
  }
  return sides;
}

void Delaunay::join(std::uint32_t cell, std::uint32_t from, std::uint32_t to, std::uint32_t beside) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (cells_[cell].corner[after(i)] == from && cells_[cell].corner[after(after(i))] == to) {
      cells_[cell].beside[i] = beside;
    }
  }
}

void Delaunay::fill_hole(const std::vector<Side>& sides, std::uint32_t apex) {
  const auto first = static_cast<std::uint32_t>(cells_.size());
  for (const Side& side : sides) {
    const auto cell = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back({{apex, side.from, side.to}, {side.beyond, no_index, no_index}});
    if (side.beyond != no_index) join(side.beyond, side.to, side.from, cell);
  }
  for (std::uint32_t i = 0; i < sides.size(); ++i) {
    for (std::uint32_t j = 0; j < sides.size(); ++j) {
      if (sides[i].to != sides[j].from) continue;
      cells_[first + i].beside[1] = first + j;
      cells_[first + j].beside[2] = first + i;
    }
  }
}

std::uint32_t Delaunay::insert(PlanPoint point) {
  const std::uint32_t start = locate(point);
  for (const std::uint32_t corner : cells_[start].corner) {
    if (points_[corner] == point) return corner;
  }
  points_.push_back(point);
  const auto apex = static_cast<std::uint32_t>(points_.size() - 1);
  fill_hole(open_hole(start, point), apex);
  return apex;
}

std::vector<std::array<std::uint32_t, 3>> Delaunay::triangles() const {
  std::vector<std::array<std::uint32_t, 3>> result;
  for (const Cell& cell : cells_) {
    if (cell.alive) result.push_back(cell.corner);
  }
  return result;
}

}  // namespace cdfr
