/// The tables of bench/peers and its JSON.
#pragma once

#include <string>
#include <vector>

#include "rounds.h"

namespace cdfr::bench {

void print_report(const std::vector<Sheet>& sheets);
/// False if the file cannot be written.
bool write_report(const std::vector<Sheet>& sheets, const std::string& path);

}  // namespace cdfr::bench
