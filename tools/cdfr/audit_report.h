/// What an audit found, as every report of a field has it.
#pragma once

#include <string>
#include <vector>

#include "cdfr/mesh/audit.h"
#include "json_report.h"
#include "text_report.h"

namespace cdfr::command {

/// All counts, whether the mesh is closed and embedded, the sign that fits and why.
Json json_of(const MeshReport& report);
void add_counts(const MeshReport& report, TextReport& text);
/// The line "mesh", and another one if bodies cross or touch: then depth and thickness are only as large as
/// the walls inside let them be.
void add_mesh(const MeshReport& report, TextReport& text);
/// What a user should know before trusting signs.
std::vector<std::string> warnings_for(const MeshReport& report);

}  // namespace cdfr::command
