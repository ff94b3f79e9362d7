/// Whether a mesh is one that the promise of right signs is made for: closed, embedded, outward.
///
/// CGAL tells whether triangles meet elsewhere than in the corners and edges that they share. Triangles of no
/// area it would always report, so they are turned away first: such a triangle, with corners a, b, c in line
/// and b in the middle, is flipped together with its neighbour (c, a, d) into (a, b, d) and (b, c, d), which
/// cover exactly the same points.
#pragma once

#include <string>

#include "cdfr/mesh/mesh.h"
#include "soak/side_oracle.h"

namespace cdfr::soak {

/// Empty if the mesh fits; else the reason why not. `mesh` as welded() leaves it.
std::string why_unfit(const Mesh& mesh, const SideOracle& oracle);

}  // namespace cdfr::soak
