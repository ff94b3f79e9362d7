/// Contours of the signed distance as closed triangle meshes.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

struct ContourMeshOptions {
  /// E: the largest distance from any point of the mesh to the true contour, and from any point of that to
  /// the mesh, in the mesh's unit; 0 takes the longest side / 1000.
  double tolerance = 0;
};

/// What could not be had everywhere, and where.
enum class ContourDoubt : std::uint8_t {
  crowded,    ///< several sheets in one cell of the deepest level: right as a surface, its shape there is the
              ///< cell's
  undecided,  ///< the contour may pass where no corner of the deepest cells shows it: thinner than those
              ///< cells
  loose,      ///< a check on the finished mesh found it farther from the contour than the tolerance
};

struct ContourPlace {
  Vec3 position;    ///< centre of the cell
  double size = 0;  ///< edge of the cell
  ContourDoubt doubt = ContourDoubt::crowded;
};

struct ContourMeshReport {
  double tolerance = 0;           ///< as it was taken
  std::uint64_t cells = 0;        ///< leaves of the octree that hold a piece of the mesh
  double smallest_cell = 0;       ///< edge of the deepest cells, whether there are any or not
  std::uint64_t evaluations = 0;  ///< of the distance
  std::uint64_t vertices = 0, triangles = 0;
  std::uint64_t crowded = 0, undecided = 0, loose = 0;  ///< places of each doubt
  std::vector<ContourPlace> places;  ///< those places, in the order of the cells; the first 10,000 of each
  /// Largest |signed distance - distance| that was measured on the finished mesh: at sharp vertices, and at a
  /// few points of each cell larger than the tolerance.
  double largest_error = 0;
  bool part_itself = false;  ///< distance 0 of a closed and embedded part: its own triangles
  Box box;                   ///< of the vertices; lo > hi if there are none
};

struct ContourMesh {
  Mesh mesh;
  ContourMeshReport report;
};

/// The contour {x : signed distance = distance} as the boundary of {signed distance < distance}: a closed
/// 2-manifold of triangles, oriented so that normals point to where the signed distance grows, which nowhere
/// meets itself. All that holds by construction, in exact arithmetic on the coordinates given back; writing
/// them as float32 (STL) may break the last. The mesh is within the tolerance of the contour and the contour
/// within the tolerance of it, but for the report's places. Sharp edges and corners of the contour are edges
/// and vertices of the mesh, but where one reaches out of a cell by less than an eighth of the tolerance.
/// Distance 0 of a closed, embedded part gives its own triangles, welded.
///
/// An empty contour is an empty mesh. Where {signed distance < distance} has no volume, such as at exactly
/// half the thickness of a plate, there is nothing to bound: no mesh, and the place is counted as undecided
/// if rounding may have left a sheet. A sheet of it, or a gap between two, that is thinner than the deepest
/// cells (at most a seventh of the tolerance) can be lost; it is counted too. Sheets thinner than the
/// tolerance take cells as small as they are thin, so triangles in millions.
///
/// The same bytes for any number of threads. Time and memory: O(cells that the contour passes); flat and
/// gently curved parts take large cells; about a kilobyte a cell while it runs, which no budget bounds.
/// Errors: bad_option (distance or tolerance not finite; tolerance below 2^-15 of the contour's box or 2^-26
/// of the largest coordinate), not_closed (the mesh is open, so that the sign changes off its surface; or the
/// field is unsigned and the distance not above 0), out_of_range (more than 2^32 - 2 triangles or cells),
/// cancelled, and the field's own. Thread safe.
CDFR_API Result<ContourMesh> contour_mesh(const Field& field, double distance,
                                          const ContourMeshOptions& options = {}, const Run& run = {});

}  // namespace cdfr
