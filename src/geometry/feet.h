/// Many points of a small region against a few triangles, in plain double precision: each triangle meets a
/// vector of points at a time.
///
/// A triangle is given by a frame for each edge: x along it from its first corner, y inwards, and h along the
/// normal, which all three share. The point's foot is on the face where all y are above what rounding may add
/// to them, else on the edge that is closest by (x beyond the edge, y).
///
/// **Bound.** Let u = 2^-53, V the largest |v - c| of the triangle's corners from the middle c, r the radius
/// of the points about it. Directions are off by 8u (a difference and its length by 5u, the normal by u,
/// their cross product by 2u more), v - c by u of itself, and products and sums by 4u: a coordinate f.p - f.v
/// is off by less than 13u (V + r). A face counts only where all y exceed that, so never where the projection
/// is outside, which past the tip of a needle may be far from the triangle; where it is given up, an edge is
/// within 26u (V + r) at a right angle to the distance. Three coordinates make a distance: sqrt(3) 13u < 24u
/// (V + r), and the foot is off by as much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "cdfr/core/types.h"
#include "geometry/point_triangle.h"

namespace cdfr {

/// A triangle with what does not depend on the point.
struct TriangleFrame {
  struct Axis {
    double way[3], start;  ///< the coordinate of p is way.p - start
  };
  struct Edge {
    Axis along, inwards;
    double length;
  };
  Edge edges[3];
  Axis height;
  double error;  ///< of a distance: 24u (V + r)
  double doubt;  ///< y has to exceed it; infinite for a triangle of no area, which has no face
};

/// As seen from the middle of points that are no farther from it than `radius`.
TriangleFrame triangle_frame(const TriangleShape& shape, const Vec3& middle, double radius) noexcept;

/// Of room for many, the first `count` count; those after them may be read as well.
struct alignas(64) RegionPoints {
  static constexpr std::size_t most = 512;
  double at[3][most];
  std::size_t count = 0;

  void add(const Vec3& p) noexcept {
    at[0][count] = p.x;
    at[1][count] = p.y;
    at[2][count] = p.z;
    ++count;
  }
  Vec3 point(std::size_t i) const noexcept { return {at[0][i], at[1][i], at[2][i]}; }
};

/// Places in an array of frames: the triangles that count.
using FrameNumbers = std::span<const std::uint16_t>;

/// By point.
struct alignas(64) Feet {
  static constexpr std::size_t most = 64;
  double distance[most];
  double away[3][most];  ///< from the foot to the point, of unit length; nothing where the distance is 0
  double number[most];   ///< of the triangle: of several that are as close, the first
  double place[most];    ///< TrianglePlace
};

/// Eight points by one triangle.
struct alignas(64) EightFeet {
  double distance[8];
  double away[3][8];
  double place[8];
};

/// The triangles that may be closest to some points.
struct NearTriangles {
  std::span<const TriangleFrame> frames;
  FrameNumbers numbers;
  /// Of each number, a plane with the triangle behind it (supports.h): its distance is at least that
  /// coordinate less `slack`. Or none at all. They only spare work: not one bit depends on them.
  std::span<const TriangleFrame::Axis> supports = {};
  double slack = 0;
};

/// Least squared distance of each point to the triangles, or the square of `most` if that is less. About 1.5
/// ns a point and triangle with AVX-512.
void squared_distances(const NearTriangles& near, const RegionPoints& points, double* squared,
                       double most = std::numeric_limits<double>::infinity()) noexcept;

/// Of the points first .. min(first + Feet::most, points.count) - 1. Precondition: `first` is a multiple of
/// Feet::most.
void find_feet(const NearTriangles& near, const RegionPoints& points, std::size_t first, Feet& feet) noexcept;

/// Of the first eight points, from each triangle on its own: feet[i] belongs to numbers[i].
void find_each_foot(std::span<const TriangleFrame> frames, FrameNumbers numbers, const RegionPoints& points,
                    EightFeet* feet) noexcept;

}  // namespace cdfr
