/// Patches as they are named on the command line.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "input.h"

namespace cdfr::command {

/// The numbers of patches that are named as in the mesh, or by number. Ends the program (Stop) at a name that
/// is neither; `option` is what it was given to.
std::vector<std::uint32_t> patch_numbers(const std::string& option, const std::vector<std::string>& names,
                                         const Input& input);

}  // namespace cdfr::command
