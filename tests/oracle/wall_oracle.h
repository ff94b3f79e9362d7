/// Wall thickness at a point of a surface, the slow way: by bisection on depths, and by every triangle in
/// turn.
#pragma once

#include <cstdint>
#include <functional>

#include "cdfr/core/types.h"
#include "cdfr/mesh/mesh.h"
#include "oracle/range.h"

namespace cdfr::oracle {

using Depth = std::function<double(const Vec3&)>;

struct Wall {
  Vec3 point, normal;    ///< outward, of unit length
  double facet = 0;      ///< D
  double largest = 0;    ///< of the diameter: a ball that could grow beyond it has the diameter infinity
  double uncertain = 0;  ///< how far `depth` and what is asked may be off: facet tolerances within it are one
};

/// Twice the largest r with depth(p - r n) >= r - D. That r - depth(p - r n) does not fall makes bisection
/// right: depths change no faster than places.
Range ball_diameter(const Depth& depth, const Wall& wall);

/// Way from the sample along the inward normal to the first triangle but its own, by Moeller and Trumbore's
/// equations in long double. Below the range's low end lies no triangle, even were each larger by 1e-12 of
/// itself; at its high end lies one that is hit even if it were smaller by that. Infinity: none.
Range first_hit(MeshView mesh, const Vec3& point, const Vec3& normal, std::uint32_t own);

}  // namespace cdfr::oracle
