/// Heavy sections as a table, or drawn in their part.
#pragma once

#include <optional>

#include "cdfr/mesh/mesh.h"
#include "sections_finding.h"

namespace cdfr::command {

/// Wrong usage, or failed, for a target that cannot be written.
void check_sections_target(const SectionsRequest& request);
/// Does the target want the part's triangles?
bool is_drawn(const SectionsRequest& request);

/// .json as on standard output, .csv with a row a section, or .glb, .ply and .vtp: the part, its triangles
/// coloured by the diameter of the section that they bound, with the balls and their labels. `part` is empty
/// unless it is drawn.
void write_sections(const SectionsRequest& request, const Input& input, const Mesh& part,
                    const SectionsFinding& finding);

}  // namespace cdfr::command
