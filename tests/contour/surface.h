/// What every surface of contour_mesh must be.
#pragma once

#include <cstdint>
#include <span>

#include "cdfr/contour/mesh.h"
#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

/// Fails unless every edge has two triangles, one in each direction, every vertex one fan, and each vertex a
/// triangle.
void expect_closed_manifold(const Mesh& mesh);

/// By CGAL, exactly: closed, not meeting itself, bounding a volume. Where CGAL was not found it says nothing.
void expect_embedded(const Mesh& mesh);

/// Extracts, checks the report and the above.
ContourMesh surface_of(const Field& field, double distance, double tolerance);

/// Largest |signed distance - distance| over `count` random points of the mesh.
double largest_excess(const Field& field, const Mesh& mesh, double distance, std::size_t count);
double largest_excess(const BruteForce& brute, const Mesh& mesh, double distance, std::size_t count);

/// Largest distance from points that cover the contour, as contour_points has them, to the mesh. Points
/// within the spacing of a place that the report lists as undecided do not count.
double largest_gap(const Field& field, const Mesh& mesh, double distance, double spacing,
                   std::span<const ContourPlace> places = {});

double volume_of(const Mesh& mesh);

}  // namespace cdfr::test
