/// What an answer must be where the truth is known: within 4 ulp of it, of the right sign, with a unit
/// gradient.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cdfr/field/field.h"
#include "faults/block_solid.h"

namespace cdfr::test {

inline double largest_of(const Vec3& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); }

inline double ulp_of(double size) { return std::nextafter(size, HUGE_VAL) - size; }

/// 4 ulp at the largest absolute coordinate of mesh and query.
inline double allowance(const Box& mesh, const Vec3& p) {
  return 4 * ulp_of(std::max({largest_of(mesh.lo), largest_of(mesh.hi), largest_of(p)}));
}

inline double length_of(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Query coordinates below 2^-300 count as 0, so only a distance above that must have a sign. On the surface
/// the distance is 0, but for 2^-90 of the sizes where triangles are thinner than that.
inline testing::AssertionResult is_right(const Field& field, const Vec3& p, long double truth) {
  const Closest c = field.closest(p);
  const auto wrong = [&](const char* what) {
    return testing::AssertionFailure() << what << ": " << c.distance << " for " << static_cast<double>(truth)
                                       << " at " << p.x << ' ' << p.y << ' ' << p.z;
  };
  const long double error = std::fabs(static_cast<long double>(c.distance) - truth);
  if (!(error <= static_cast<long double>(allowance(field.bounds(), p)))) return wrong("distance");
  if (std::fabs(truth) > 0x1p-290L && (c.distance < 0) != (truth < 0)) return wrong("sign");
  if (std::fabs(truth) > 0x1p-290L && c.distance == 0) return wrong("zero");
  if (truth == 0 && std::fabs(c.distance) > 0x1p-40 * allowance(field.bounds(), p)) return wrong("surface");
  if (!(std::fabs(length_of(c.gradient) - 1) <= 1e-15)) return wrong("gradient");
  if (field.distance(p) != c.distance) return wrong("two answers");
  return testing::AssertionSuccess();
}

/// Points all around the solid, on its planes and very near to them.
inline void expect_right(const Field& field, const BlockSolid& solid, int count, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const Vec3 p = point_near(solid, random);
    ASSERT_TRUE(is_right(field, p, solid.distance(p)));
  }
}

}  // namespace cdfr::test
