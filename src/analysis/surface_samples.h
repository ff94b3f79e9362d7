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
  double facet = 0;        ///< of its triangle, at a vertex the largest of its triangles'
};

/// By triangle number; `slots` are by it, `facets` by slot. Triangles of no area have no normal, so none of
/// their own; a vertex whose normals cancel has none either. A vertex belongs to its lowest triangle, its
/// normal is the mean weighted by angle, its area a third of its triangles'. At a spacing a triangle is
/// halved at its longest side until that is at most 3/2 of the spacing (Rivara, "Algorithms for refining
/// triangular grids suitable for adaptive and multigrid techniques", 1984), and the centres of the parts are
/// taken: no point of the triangle is farther than two thirds of that side from one. Positions are within 8
/// ulp of the largest coordinate of the triangle. Errors: bad_option (more than 2^32 - 2 samples).
/// O(triangles and samples).
Result<std::vector<SurfaceSample>> surface_samples(const FieldData& field,
                                                   std::span<const std::uint32_t> slots,
                                                   std::span<const double> facets, SampleAt at,
                                                   double spacing);

double area_of(const TriangleShape& shape) noexcept;

}  // namespace cdfr
