/// The regions that a contour may pass through, by either source.
#pragma once

#include <cstddef>
#include <vector>

#include "cdfr/reference/uniform_contour.h"
#include "core/progress.h"
#include "reference/uniform_data.h"

namespace cdfr {

/// papers/huang-2001, section 3.5, equation 2: voxels with a list whose first distance is within sqrt(3)/2 s
/// of the depth.
std::vector<std::size_t> voxels_near(const UniformData& data, double depth);

/// papers/huang-2001-report, section 3.4: a region lies between the centres of a voxel and its seven
/// neighbours towards larger coordinates, and is named by that voxel. Those whose corners' depths reach both
/// `depth` or less and `depth` or more; a dropped voxel is at any depth below zero. Runs in the caller's task
/// arena.
std::vector<std::size_t> inter_voxels_across(const UniformData& data, double depth, Progress& progress);

/// The eight voxels' lists together, each triangle once, by number; distances are those from some of the
/// centres.
std::vector<CddTuple> united_lists(const UniformData& data, std::size_t region);

}  // namespace cdfr
