/// What the soak is asked for on its command line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cdfr/core/types.h"

namespace cdfr::soak {

struct Options {
  std::uint64_t points = 100'000'000;
  std::uint64_t meshes = 100;
  std::uint64_t seed = 1;
  unsigned threads = 0;
  std::uint64_t second_opinion = 16;
  bool lenient = false;       ///< wrong within 4 ulp is not wrong
  std::string only;           ///< part of the names of the meshes to take
  std::string replay;         ///< name of a mesh; empty: the soak
  std::optional<Vec3> point;  ///< of the replay
  std::string write;          ///< file for the replay's mesh
};

/// The options, or the status to exit with.
struct Parsed {
  Options options;
  std::optional<int> exit_status;
};
Parsed parse(int argc, char** argv);

}  // namespace cdfr::soak
