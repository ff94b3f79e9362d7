#include "geometry/planar_orientation.h"

#include "geometry/expansion.h"

namespace cdfr {

int exact_planar_orientation(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) noexcept {
  return (exact_difference(b.u, a.u) * exact_difference(c.v, a.v) -
          exact_difference(b.v, a.v) * exact_difference(c.u, a.u))
      .sign();
}

}  // namespace cdfr
