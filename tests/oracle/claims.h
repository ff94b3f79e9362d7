/// What the library claims of a Closest, as numbers that can be held to bounds.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "cdfr/field/field.h"
#include "oracle/exact_distance.h"
#include "oracle/shapes.h"

namespace cdfr::oracle {

/// M is the largest absolute coordinate of query and mesh.
enum class Claim : std::size_t {
  distance,    ///< | |distance| - exact |, in ulp(M)
  point,       ///< largest coordinate of point - exact closest point, in ulp(M)
  on_surface,  ///< exact distance of point from the triangle, in ulps at the triangle's largest coordinate
  consistent,  ///< | |x - point| - |distance| |, in ulp(M)
  barycentric_sum,     ///< |sum - 1|
  barycentric_range,   ///< farthest that one is outside [0, 1]
  barycentric_point,   ///< largest coordinate of (corners combined - point), in ulp(M)
  element,             ///< 0 if the feature's number and its barycentrics fit: 0 off an edge, 1 at a vertex
  gradient_length,     ///< | |gradient| - 1 |
  gradient_direction,  ///< |distance * gradient - (x - exact closest point)| beyond 1e-12 |distance|, in
                       ///< ulp(M)
};
inline constexpr std::size_t claim_count = 10;

/// What each claim must stay within, and its name.
struct Bound {
  const char* name;
  double limit;
};
const Bound& bound_of(Claim claim) noexcept;

using Errors = std::array<double, claim_count>;

/// The mesh's `largest` coordinate counts in M. `exact` is the exact distance of x from the triangle with
/// these corners, which is the one that `closest` names.
Errors errors_of(const Closest& closest, Vec3 x, const Corners& corners, const Exact& exact, double largest);

/// The worst of many errors, each with the case that it came from.
class Worst {
 public:
  /// NaN counts as infinite. `describe` is called only for a case that is worse than all before.
  template <class Describe>
  void add(const Errors& errors, Describe describe) {
    for (std::size_t i = 0; i < claim_count; ++i) {
      const double error = std::isnan(errors[i]) ? std::numeric_limits<double>::infinity() : errors[i];
      if (error > worst_[i]) worst_[i] = error, where_[i] = describe();
    }
  }
  double operator[](Claim claim) const { return worst_[static_cast<std::size_t>(claim)]; }
  /// A failure of the running test for each claim that is broken, with its worst case.
  void expect_within_bounds() const;
  /// One line with all of them.
  std::string text() const;

 private:
  Errors worst_{};
  std::array<std::string, claim_count> where_;
};

/// Bits of the coordinates, so that a failure can be replayed.
std::string replay(Vec3 x, const Corners& corners);

}  // namespace cdfr::oracle
