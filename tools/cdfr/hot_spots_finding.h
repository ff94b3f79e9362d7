/// What the verb sections was asked without a depth, and the hot spots that it has found.
#pragma once

#include <string>
#include <vector>

#include "cdfr/analysis/hot_spots.h"
#include "input.h"
#include "provenance.h"
#include "settings.h"

namespace cdfr::command {

struct HotSpotsRequest {
  std::string input, output, part;
  HotSpotOptions options;
  std::vector<std::string> feeders;  ///< patches as they were named
  Settings settings;
};

struct HotSpotsFinding {
  HotSpots found;
  Provenance provenance;
  double seconds = 0;
};

}  // namespace cdfr::command
