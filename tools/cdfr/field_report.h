/// What info says of a field, and build of the one that it has made.
#pragma once

#include <string>

#include "input.h"
#include "json_report.h"

namespace cdfr::command {

Json field_json(const std::string& name, const Input& input);
std::string field_text(const std::string& name, const Input& input);

}  // namespace cdfr::command
