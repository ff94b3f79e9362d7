/// Options that are numbers: the whole word, decimal, in its range, or wrong usage.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "command_line.h"

namespace cdfr::command {

/// A closed range.
struct Range {
  double least = -std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::max();
};

/// The whole word as a finite number.
bool parse_number(const std::string& word, double& value);

/// Rounded once, to the nearest double; never NaN or infinite.
CLI::Option* add_number(CLI::App& verb, const std::string& name, double& target, const Range& range,
                        const std::string& description);

CLI::Option* add_count(CLI::App& verb, const std::string& name, int& target, int least, int greatest,
                       const std::string& description);

CLI::Option* add_count(CLI::App& verb, const std::string& name, std::uint64_t& target, std::uint64_t least,
                       std::uint64_t greatest, const std::string& description);

/// Bytes: a whole number, with KiB, MiB, GiB or TiB behind it if that is meant (2GiB).
CLI::Option* add_size(CLI::App& verb, const std::string& name, std::uint64_t& target,
                      const std::string& description);

}  // namespace cdfr::command
