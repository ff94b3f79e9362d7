/// The thinnest places of a part: connected samples that are thin.
#pragma once

#include <span>

#include "analysis/sample_neighbours.h"
#include "cdfr/analysis/thickness.h"

namespace cdfr {

/// Fills in thin_limit, thin areas and places of the report, which has the statistics.
void find_thin_places(std::span<const ThicknessSample> samples, const SampleNeighbours& neighbours,
                      const ThicknessOptions& options, ThicknessReport& report);

}  // namespace cdfr
