/// Solids built up in layers over one plan. Every cell is a prism: a triangle of the plan times a layer.
/// Solid cells share whole faces, edges or corners, so the border between solid and void is closed by
/// construction, and it is embedded as long as the levels keep their order over every point of the plan.
#pragma once

#include <span>

#include "cdfr/mesh/mesh.h"
#include "parts/recipe.h"

namespace cdfr {

struct LayerOptions {
  double spacing = 5;  ///< length of triangle sides in the plan, mm
  double layer = 5;    ///< height of a layer at most, mm
  Vec3 size;           ///< the box from the origin that holds all steps
  /// Where the point (x, y, z) of the recipe goes, vertically; strictly increasing in z, exact at 0 and
  /// size.z.
  double (*lift)(double x, double y, double z) noexcept = nullptr;
};

/// At most 64 layers. The steps' heights are levels.
Mesh build_layers(std::span<const Step> steps, const LayerOptions& options);

}  // namespace cdfr
