/// Where on a part's surface something is measured: at vertices, at face centres, or at a given spacing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cdfr/analysis/thickness.h"
#include "cdfr/core/result.h"
#include "field/field_data.h"

namespace cdfr {

struct SurfaceSample {
  Vec3 position;
  Vec3 normal;             ///< outward, unit
  std::uint32_t slot = 0;  ///< that it lies on
  double area = 0;         ///< that it stands for
};

/// By triangle number; `slots` are by it. Triangles of no area have no normal, so none of their own; a vertex
/// whose normals cancel has none either. A vertex belongs to its lowest triangle, its normal is the mean
/// weighted by angle, its area a third of its triangles'. Samples at a spacing lie in rows along the
/// triangle's longest side, each row cut into equal parts, so that a needle takes no more than it needs.
/// Positions are within 8 ulp of the largest coordinate of the triangle. Errors: bad_option (more than 2^32 -
/// 2 samples). O(triangles and samples).
Result<std::vector<SurfaceSample>> surface_samples(const FieldData& field,
                                                   std::span<const std::uint32_t> slots, SampleAt at,
                                                   double spacing);

double area_of(const TriangleShape& shape) noexcept;

}  // namespace cdfr
