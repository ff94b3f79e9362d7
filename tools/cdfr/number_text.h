/// Numbers as text, the same in every locale.
#pragma once

#include <cstdint>
#include <string>

#include "cdfr/core/types.h"

namespace cdfr::command {

/// The shortest text that reads back as the same bits: at most 17 significant digits.
void append_exact(std::string& text, double value);

/// For people: at most 9 significant digits.
std::string short_text(double value);
std::string short_text(Vec3 value);
/// "8.50 mm +- 0.05": the error with one digit, or two if the first is 1 or 2, rounded up, and the value with
/// as many decimals, at most 9 digits in all. What rounding takes from the value is added to the error, so
/// the true number lies within what is shown (to 1 in 10^12 of the error). An error of 0 shows every digit of
/// the value.
std::string bounded_text(double value, double error, const std::string& unit);
std::string count_text(std::uint64_t value);
/// "3.2 s", "180 ms".
std::string seconds_text(double seconds);
/// "12.3 MiB".
std::string bytes_text(std::uint64_t bytes);

}  // namespace cdfr::command
