/// Delaunay triangulation of a rectangle on an integer grid. All tests are exact, so nothing depends on
/// rounding.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace cdfr {

/// A point of the plan, in units of 2^-10 of the recipe's: every coordinate is an exact double.
struct PlanPoint {
  std::int64_t x = 0, y = 0;
  friend bool operator==(const PlanPoint&, const PlanPoint&) = default;
  friend bool operator<(const PlanPoint& a, const PlanPoint& b) noexcept {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }
};

/// Twice the signed area of a, b, c; positive if they turn counter-clockwise.
std::int64_t turn(PlanPoint a, PlanPoint b, PlanPoint c) noexcept;

class Delaunay {
 public:
  /// Two triangles on the rectangle from (0, 0) to `far`; coordinates below 2^20.
  explicit Delaunay(PlanPoint far);

  /// The vertex at `point`, new or known. Precondition: inside the rectangle or on its border.
  std::uint32_t insert(PlanPoint point);

  const std::vector<PlanPoint>& points() const noexcept { return points_; }
  /// Counter-clockwise, in an order that depends on the insertions alone.
  std::vector<std::array<std::uint32_t, 3>> triangles() const;

 private:
  /// beside[i] is the triangle across the side that faces corner[i].
  struct Cell {
    std::array<std::uint32_t, 3> corner;
    std::array<std::uint32_t, 3> beside;
    bool alive = true;
  };
  /// One side of the hole that an insertion makes, with the triangle beyond it.
  struct Side {
    std::uint32_t from, to, beyond;
  };
  std::uint32_t locate(PlanPoint point) const;
  bool circle_holds(const Cell& cell, PlanPoint point) const;
  std::vector<Side> open_hole(std::uint32_t start, PlanPoint point);
  void fill_hole(const std::vector<Side>& sides, std::uint32_t apex);
  void join(std::uint32_t cell, std::uint32_t from, std::uint32_t to, std::uint32_t beside);

  std::vector<PlanPoint> points_;
  std::vector<Cell> cells_;
};

}  // namespace cdfr
