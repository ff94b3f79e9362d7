/// The nodes of a glTF scene that show a mesh, in the order of the scene, each with its place in the world.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"
#include "mesh/gltf_document.h"

namespace cdfr {

/// x -> rows * (x, 1).
struct Affine {
  std::array<std::array<double, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  Vec3 apply(const Vec3& p) const noexcept;
};

struct GltfInstance {
  std::uint64_t mesh = 0;
  Affine world;
  bool mirrored = false;  ///< the transform turns the winding of triangles round
};

/// Depth first, parents before children. A node that is reached twice (a cycle, or two parents) is refused.
std::vector<GltfInstance> gltf_instances(const Json& root);

}  // namespace cdfr
