#include "geometry/solid_angle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/winding.h"

namespace cdfr {
namespace {

constexpr double pi = 3.141592653589793;

TEST(SolidAngle, OfAnOctantIsAnEighthOfTheSphere) {
  const std::array<Vec3, 3> octant{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  EXPECT_NEAR(solid_angle({0, 0, 0}, octant).value, pi / 2, 1e-14);
  EXPECT_NEAR(solid_angle({0, 0, 0}, {octant[0], octant[2], octant[1]}).value, -pi / 2, 1e-14);
}

TEST(SolidAngle, IsWithinItsErrorOfTheDefinition) {
  test::Random random(3);
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  for (int i = 0; i < 20000; ++i) {
    Mesh one;
    one.vertices = {random.in(box), random.in(box), random.in(box)};
    one.triangles = {{0, 1, 2}};
    const double off = std::ldexp(1.0, -static_cast<int>(random.below(40)));
    const Vec3 near = one.vertices[random.below(3)], shift = random.in(box);
    const Vec3 p{near.x + off * shift.x, near.y + off * shift.y, near.z + off * shift.z};
    const Bounded angle = solid_angle(p, {one.vertices[0], one.vertices[1], one.vertices[2]});
    EXPECT_LE(angle.error, 1e-9);
    EXPECT_NEAR(angle.value, 4 * pi * test::brute_winding(one.view(), p), angle.error + 1e-12);
  }
}

TEST(SolidAngle, HasTheRightSignAnUlpOffTheFace) {
  const std::array<Vec3, 3> t{Vec3{0, 0, 1}, Vec3{4, 0, 1}, Vec3{0, 4, 1}};
  EXPECT_NEAR(solid_angle({1, 1, std::nextafter(1.0, 0)}, t).value, 2 * pi, 1e-12);
  EXPECT_NEAR(solid_angle({1, 1, std::nextafter(1.0, 2)}, t).value, -2 * pi, 1e-12);
  EXPECT_EQ(solid_angle({3, 3, 1}, t).value, 0);
}

TEST(SolidAngle, IsTheSameAtAnySizeAndZeroWithoutArea) {
  const std::array<Vec3, 3> t{Vec3{0, 0, 1}, Vec3{4, 0, 1}, Vec3{0, 4, 2}};
  const Vec3 p{1, 1, 0.25};
  const double expected = solid_angle(p, t).value;
  for (const int k : {-198, -60, 60, 198}) {
    const auto times = [k](const Vec3& v) {
      return Vec3{std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
    };
    EXPECT_EQ(solid_angle(times(p), {times(t[0]), times(t[1]), times(t[2])}).value, expected) << k;
  }
  EXPECT_EQ(solid_angle(p, {t[0], t[0], t[1]}).value, 0);
  EXPECT_EQ(solid_angle(p, {Vec3{0, 0, 0}, Vec3{1, 1, 1}, Vec3{3, 3, 3}}).value, 0);
}

}  // namespace
}  // namespace cdfr
