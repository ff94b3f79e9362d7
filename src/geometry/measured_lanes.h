/// The kernel for sixteen pairs of point and triangle side by side: the same bits as `measure` in each lane,
/// at a fraction of the time.
#pragma once

#include <cstddef>

#include "cdfr/core/types.h"
#include "geometry/point_triangle.h"

namespace cdfr {

inline constexpr std::size_t lane_count = 16;

/// Structure of arrays. Every lane has to hold a pair that `measure` would take; a lane that is not needed
/// may repeat another one.
struct alignas(64) PairLanes {
  double point[3][lane_count];        ///< [axis][lane]
  double vertices[3][3][lane_count];  ///< [corner][axis][lane]
  double normal[3][lane_count];       ///< high parts
  double normal_rest[3][lane_count];  ///< low parts

  void set(std::size_t lane, const Vec3& p, const TriangleShape& triangle) noexcept;
  Vec3 p(std::size_t lane) const noexcept { return {point[0][lane], point[1][lane], point[2][lane]}; }
  TriangleShape triangle(std::size_t lane) const noexcept;
};

/// Points that meet one triangle.
struct alignas(64) PointLanes {
  double at[3][lane_count];  ///< [axis][lane]

  void set(std::size_t lane, const Vec3& p) noexcept {
    at[0][lane] = p.x;
    at[1][lane] = p.y;
    at[2][lane] = p.z;
  }
  Vec3 p(std::size_t lane) const noexcept { return {at[0][lane], at[1][lane], at[2][lane]}; }
};

/// Feet as `measure` gives them, and the distance. The offset of a foot on a face is the normal times `along`
/// and not kept.
struct alignas(64) MeasuredLanes {
  double distance[lane_count];  ///< square_root of the squared distance
  double squared[lane_count], squared_rest[lane_count];
  double along[lane_count], along_rest[lane_count];
  double offset[3][lane_count], offset_rest[3][lane_count];
  TrianglePlace place[lane_count];

  /// Precondition: the triangle is the lane's.
  Foot foot(const TriangleShape& triangle, std::size_t lane) const noexcept;
};

/// With AVX-512 about 7 ns a lane on faces, 9 at corners, 15 on edges; 19 where lanes of all kinds mix, so it
/// pays to put those of one kind together. AVX2 takes twice as long. Lanes where double precision leaves the
/// place open, or whether the distance is zero, are measured one by one.
void measure(const PairLanes& pairs, MeasuredLanes& measured) noexcept;

/// The same for a triangle and points whose feet certainly lie at that place; where it is an edge or a
/// corner, none is at a distance of zero (PlaceEstimate).
void measure_at(const TriangleShape& triangle, TrianglePlace place, const PointLanes& points,
                MeasuredLanes& measured) noexcept;

}  // namespace cdfr
