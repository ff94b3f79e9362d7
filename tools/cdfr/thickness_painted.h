/// The part coloured by its wall thickness, for looking and for ParaView.
#pragma once

#include <string>

#include "cdfr/mesh/mesh.h"
#include "thickness_request.h"

namespace cdfr::command {

/// A .glb or .vtp of the mesh with thickness, error and at_edge on its vertices or triangles, the first as
/// colour from its 1 % to its 99 % quantile, and the thinnest places as labels. Of several samples a
/// triangle has the thinnest. Ends the program (Stop) if it cannot be written.
void write_thickness_painted(const ThicknessRequest& request, const Mesh& mesh, const std::string& unit,
                             const ThicknessFinding& finding);

}  // namespace cdfr::command
