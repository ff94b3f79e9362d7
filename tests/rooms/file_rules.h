/// What every file and folder of the project keeps, whatever it includes: no file over 600 lines, no empty
/// folder, sources listed in CMake and never globbed, no streams of the console in the library, public
/// headers free of TBB and Eigen.
#pragma once

#include <string>
#include <vector>

#include "rooms/source_tree.h"

namespace cdfr::rooms {

/// One line "file: what" for each breach.
std::vector<std::string> file_violations(const SourceTree& tree);

}  // namespace cdfr::rooms
