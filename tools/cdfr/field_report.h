/// What info says of a field, and build of the one that it has made.
#pragma once

#include <string>

#include "input.h"
#include "json_report.h"

namespace cdfr::command {

/// The beginning of every report on what a field was asked: input, unit, sign, audit.
Json begin_field_report(const std::string& name, const Input& input);
Json field_json(const std::string& name, const Input& input);
std::string field_text(const std::string& name, const Input& input);

}  // namespace cdfr::command
