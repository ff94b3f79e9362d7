/// Heavy sections for programs and for people.
#pragma once

#include <string>

#include "json_report.h"
#include "sections_finding.h"

namespace cdfr::command {

Json sections_json(const SectionsRequest& request, const Input& input, const SectionsFinding& finding);
std::string sections_text(const SectionsRequest& request, const Input& input, const SectionsFinding& finding);

/// "17.0 mm +- 0.1, depth 8.50 mm +- 0.05".
std::string thickness_text(const InscribedBall& ball, const std::string& unit);

}  // namespace cdfr::command
