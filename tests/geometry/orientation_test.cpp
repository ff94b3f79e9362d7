#include "geometry/orientation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace cdfr {
namespace {

/// Coordinates that are small integers: the determinant is an exact 64-bit integer.
Vec3 lattice_point(test::Random& random) {
  const auto c = [&] { return static_cast<double>(random.below(9)) - 4; };
  return {c(), c(), c()};
}

int integer_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const auto n = [](double v) { return static_cast<long long>(v); };
  const long long ex = n(b.x - a.x), ey = n(b.y - a.y), ez = n(b.z - a.z);
  const long long fx = n(c.x - a.x), fy = n(c.y - a.y), fz = n(c.z - a.z);
  const long long rx = n(p.x - a.x), ry = n(p.y - a.y), rz = n(p.z - a.z);
  const long long d = (ey * fz - ez * fy) * rx + (ez * fx - ex * fz) * ry + (ex * fy - ey * fx) * rz;
  return d > 0 ? 1 : (d < 0 ? -1 : 0);
}

TEST(Orientation, AgreesWithIntegers) {
  test::Random random(3);
  int coplanar = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec3 a = lattice_point(random), b = lattice_point(random), c = lattice_point(random),
               p = lattice_point(random);
    const int expected = integer_orientation(a, b, c, p);
    coplanar += expected == 0;
    ASSERT_EQ(orientation(a, b, c, p), expected);
  }
  EXPECT_GT(coplanar, 100);
}

TEST(Orientation, SeesOneUlpOffAPlane) {
  const Vec3 a{0.1, 0.2, 0.3}, b{0.9, 0.4, 0.3}, c{0.3, 0.8, 0.3};
  const Vec3 on{0.4, 0.4, 0.3};
  EXPECT_EQ(orientation(a, b, c, on), 0);
  EXPECT_EQ(orientation(a, b, c, {on.x, on.y, std::nextafter(on.z, 1)}), 1);
  EXPECT_EQ(orientation(a, b, c, {on.x, on.y, std::nextafter(on.z, 0)}), -1);
}

}  // namespace
}  // namespace cdfr
