/// How far a tessellation lies from the smooth surface that it stands for.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/triangle_edges.h"
#include "cdfr/analysis/thickness.h"
#include "field/field_data.h"

namespace cdfr {

/// The chord error of a triangle is taken as the sum over its smooth edges of h tan(a / 4) / 2, a the edge's
/// turn and h the smaller height of the two triangles over it: an arc that turns by a over a chord h has that
/// sagitta. Exact for a prism round a cylinder, 12 % above the sagitta of a sphere of equilateral triangles.
/// The smaller height, since a plane that goes over into a fillet has large triangles and no chord error.
///
/// That is each triangle's own: it is at the sample that a ball needs a tolerance, where the facets around
/// hold it that the smooth surface does not have. A tolerance that is too small by a share of itself makes
/// the ball at a vertex of a sphere too small by that share; one that is too large adds no more than what it
/// is too large by, and the whole of it between parallel walls, so plane triangles have none. Nearly the
/// largest error of the mesh bounds it, so that noise does not: a quantile by curved area, of each triangle
/// the part within those heights of its bent edges. A triangle is curved if its error exceeds what float32
/// coordinates can bring about.
struct FacetErrors {
  FacetEstimate estimate;
  std::vector<double> by_slot;  ///< chord error of each triangle, at most the quantile; 0 of plane ones
};

FacetErrors estimate_facets(const FieldData& field, const TriangleEdges& edges, double sharp);

}  // namespace cdfr
