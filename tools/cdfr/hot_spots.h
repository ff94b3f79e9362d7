/// The verb sections without a depth.
#pragma once

#include "command_line.h"
#include "hot_spots_finding.h"

namespace cdfr::command {

/// Finds, writes and says. Feeders are patch numbers, or names that the mesh has.
void hot_spots_of_input(HotSpotsRequest request, const CLI::App& verb);

}  // namespace cdfr::command
