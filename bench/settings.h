/// The settings that bench/sweep goes through: fields of several thresholds and levels, and the peers.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"
#include "cdfr/octree/options.h"
#include "system.h"

namespace cdfr::bench {

struct Setting {
  std::string name;
  BuildOptions options;                                               ///< of a field; a peer has none
  std::function<Result<std::unique_ptr<System>>(const Mesh&)> build;  ///< on one thread
};

/// The field that splits nothing: a BVH, for which every other one must pay back its longer build.
inline constexpr const char* bvh_name = "bvh";

/// The BVH, the fields, then the peers; fewer fields if `quick`.
std::vector<Setting> settings(bool quick);

}  // namespace cdfr::bench
