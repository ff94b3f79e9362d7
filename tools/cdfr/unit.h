/// The unit of length: a label that is echoed, and a scale where a format has one of its own.
#pragma once

#include <optional>
#include <string>

namespace cdfr::command {

/// Metres in one unit, for labels that name a length; nothing for others.
std::optional<double> metres_in(const std::string& unit);

/// What is wrong with it as a label, or empty.
std::string unit_fault(const std::string& unit);

/// "" or " mm".
std::string after_number(const std::string& unit);

}  // namespace cdfr::command
