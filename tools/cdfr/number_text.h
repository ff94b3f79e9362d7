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
std::string count_text(std::uint64_t value);
/// "3.2 s", "180 ms".
std::string seconds_text(double seconds);
/// "12.3 MiB".
std::string bytes_text(std::uint64_t bytes);

}  // namespace cdfr::command
