/// What cdfr thickness says, for programs and for people.
#pragma once

#include <string>

#include "json_report.h"
#include "thickness_request.h"

namespace cdfr::command {

Json thickness_json(const ThicknessRequest& request, const Input& input, const ThicknessFinding& finding);
std::string thickness_text(const ThicknessRequest& request, const Input& input,
                           const ThicknessFinding& finding);

}  // namespace cdfr::command
