/// A report for programs: one JSON object on standard output.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cdfr/core/types.h"

namespace cdfr::command {

/// Keys come out in the order in which they were set.
using Json = nlohmann::ordered_json;

/// Every report begins so. `input` is empty where there is none.
Json begin_report(const std::string& input, const std::string& unit);

Json json_of(Vec3 value);
/// null if the box holds nothing (lo > hi).
Json json_of(const Box& box);

/// As it is printed, with its last line's end.
std::string text_of(const Json& report);
/// Names that are no UTF-8 have their bad bytes replaced; numbers that are not finite become null.
void print_json(const Json& report);

}  // namespace cdfr::command
