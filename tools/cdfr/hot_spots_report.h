/// Hot spots for programs and for people.
#pragma once

#include <string>

#include "hot_spots_finding.h"
#include "json_report.h"

namespace cdfr::command {

Json hot_spots_json(const HotSpotsRequest& request, const Input& input, const HotSpotsFinding& finding);
std::string hot_spots_text(const HotSpotsRequest& request, const Input& input,
                           const HotSpotsFinding& finding);
/// With a header line, a row a hot spot.
std::string hot_spots_csv(const HotSpots& found);

}  // namespace cdfr::command
