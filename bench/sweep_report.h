/// The table of bench/sweep and its JSON.
#pragma once

#include <string>
#include <vector>

#include "rounds.h"
#include "settings.h"

namespace cdfr::bench {

void print_sweep(const std::vector<Sheet>& sheets, const std::vector<Setting>& settings);
/// False if the file cannot be written.
bool write_sweep(const std::vector<Sheet>& sheets, const std::vector<Setting>& settings,
                 const std::string& path);

}  // namespace cdfr::bench
