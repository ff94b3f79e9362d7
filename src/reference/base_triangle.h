/// The paper's signed distance: by the base triangle's normal.
#pragma once

#include <cstdint>
#include <span>

#include "cdfr/core/types.h"
#include "cdfr/reference/uniform.h"
#include "geometry/point_triangle.h"
#include "reference/uniform_data.h"

namespace cdfr {

/// The triangle whose normal gives the sign, and the side that it says: 1 outside, -1 inside, 0 on it.
struct BaseTriangle {
  std::uint32_t number = no_index;
  int side = 0;
};

/// papers/huang-2001, section 3.2. C1: the closest triangle itself. C2 and C3: of the triangles at that edge
/// or vertex the one with the largest |V . Normal|, V from the foot to the point; ties to the lowest number.
/// At vertices this is wrong (papers/huang-2001/README.md).
BaseTriangle base_triangle(const ReferenceSurface& surface, std::uint32_t closest, const Foot& foot) noexcept;

/// Over the triangles listed. Precondition: some are, or distance is NaN.
UniformClosest closest_among(const ReferenceSurface& surface, const Vec3& x,
                             std::span<const CddTuple> list) noexcept;

/// Section 3.5 by the letter: the least positive one of the listed triangles' own signed distances, each
/// signed by its base triangle; positive is inside, as in the paper. Infinite distance if there is none.
UniformClosest least_positive_among(const ReferenceSurface& surface, const Vec3& x,
                                    std::span<const CddTuple> list) noexcept;

}  // namespace cdfr
