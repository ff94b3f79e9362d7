// Large parts with fine detail, far origins, thin walls and odd units: promise 1 holds, or the range is
// refused by name.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cdfr/field/field.h"
#include "cdfr/mesh/audit.h"
#include "cdfr/mesh/weld.h"
#include "faults/block_solid.h"
#include "faults/plain_distance.h"
#include "faults/promise.h"
#include "faults/star.h"
#include "support/joined.h"

namespace cdfr {
namespace {

void expect_right(const test::BlockSolid& solid, std::uint64_t seed) {
  const Field field = Field::build(solid.mesh().view()).value();
  EXPECT_TRUE(field.report().embedded()) << sign_reason(field.report());
  test::expect_right(field, solid, 2000, seed);
}

TEST(LostDigits, TenMetresWithDetailOfAMicrometre) {
  // In metres: a step, and a groove beside it, of 1e-6 each.
  const test::BlockSolid part({0, 4, 4 + 1e-6, 10}, {0, 10}, {0, 1 - 1e-6, 1},
                              [](int i, int, int k) { return k == 0 || i == 0; });
  expect_right(part, 1);
  const test::BlockSolid grooved({0, 4, 4 + 1e-6, 10}, {0, 10}, {0, 1 - 1e-6, 1},
                                 [](int i, int, int k) { return k == 0 || i != 1; });
  expect_right(grooved, 2);
}

TEST(LostDigits, AMillionFromTheOrigin) {
  for (const Vec3& at : {Vec3{1e6, 0, 0}, Vec3{-1e6, 1e6, 1e6}, Vec3{1e6, -3, 0x1p40}}) {
    expect_right(test::block({at, {at.x + 1, at.y + 1, at.z + 1}}), 3);
  }
}

TEST(LostDigits, WallsOfAMillionthNearAndFarFromTheOrigin) {
  for (const double at : {0.0, 1.0, -1e3, 1e6}) {
    expect_right(
        test::BlockSolid({at, at + 1e-6, at + 1, at + 1 + 1e-6}, {at, at + 1}, {at, at + 1e-6, at + 1},
                         [](int i, int, int k) { return i != 1 || k == 0; }),
        4);
  }
}

TEST(LostDigits, SidesOneToAMillionMillion) {
  expect_right(test::block({{0, 0, 0}, {1, 1, 1e-12}}), 5);
  expect_right(test::block({{0, 0, 0}, {1e-12, 1e-12, 1}}), 6);
  expect_right(test::block({{0, 0, 0}, {1e6, 1, 1e-6}}), 7);
  expect_right(test::block({{-1e-12, -0.5, -1e-12}, {1e-12, 0.5, 1e-12}}), 8);
}

TEST(LostDigits, UnitsFromAnAtomToAStar) {
  for (const double unit : {1e-30, 1e-9, 1e-3, 1e3, 1e9, 1e30}) {
    expect_right(test::BlockSolid({0, 0.3 * unit, unit}, {-unit, 2 * unit}, {0, 0.1 * unit, unit},
                                  [](int i, int, int k) { return i == 0 || k == 0; }),
                 9);
  }
}

TEST(LostDigits, AtBothEndsOfTheRange) {
  expect_right(test::block({{0x1p-200, 0x1p-200, 0x1p-199}, {0x1.8p-199, 0x1p-198, 0x1p-198}}), 10);
  expect_right(test::block({{-0x1p-200, 0, -0x1p-200}, {0x1p-200, 0x1p-200, 0}}), 11);
  expect_right(test::block({{0, -0x1p199, 0x1p198}, {0x1p200, 0x1p199, 0x1p200}}), 12);
  expect_right(test::block({{-0x1p200, -0x1p200, -0x1p200}, {0x1p200, 0x1p200, 0x1p200}}), 13);
  expect_right(test::block({{0x1p-200, 0x1p-200, 0x1p-200}, {0x1p200, 0x1p200, 0x1p200}}), 14);
  expect_right(test::BlockSolid({0, 0x1p-200, 1, 0x1p200}, {0, 1}, {0, 0x1p-200, 0x1p200},
                                [](int i, int, int k) { return i != 1 || k == 0; }),
               15);
}

/// Slanted faces, edges and corners of all kinds: whole coordinates, so that the truth is known.
TEST(LostDigits, SlantedFacesFarFromTheOriginAndInAnyUnit) {
  const Mesh star = test::spiky_star(1, 3);
  const Vec3 shift{16384, -8192, 4096};
  for (const int power : {0, -20, -180, 30, 180}) {
    Mesh mesh = test::moved(star, shift);
    const Mesh whole = mesh;
    const auto scaled = [&](const Vec3& v) {
      return Vec3{std::ldexp(v.x, power), std::ldexp(v.y, power), std::ldexp(v.z, power)};
    };
    for (Vec3& v : mesh.vertices) v = scaled(v);
    const Field field = Field::build(mesh.view()).value();
    test::Random random(16);
    for (int i = 0; i < 1000; ++i) {
      Vec3 p = test::point_by_feature(star, random);
      const int side = test::exact_side(star, p);
      p = {p.x + shift.x, p.y + shift.y, p.z + shift.z};
      const long double truth = std::ldexp(test::plain_distance(p, whole), power) * (side < 0 ? -1 : 1);
      ASSERT_TRUE(side == 0 || test::is_right(field, scaled(p), truth)) << power;
    }
  }
}

TEST(LostDigits, DenormalQueriesAndMinusZero) {
  const Box box{{0, -1, -1}, {2, 1, 1}};
  const test::BlockSolid solid = test::block(box);
  const Field field = Field::build(solid.mesh().view()).value();
  for (const double tiny : {5e-324, -5e-324, 1e-310, -1e-310, 0x1p-1022, 1e-200, -1e-200}) {
    for (const Vec3& p : {Vec3{tiny, 0, 0}, Vec3{tiny, 1, tiny}, Vec3{1, tiny, 1}, Vec3{-1, tiny, -tiny}}) {
      ASSERT_TRUE(test::is_right(field, p, solid.distance(p))) << tiny;
    }
  }
  EXPECT_EQ(field.distance({-0.0, -0.0, -0.0}), 0);
  Mesh negative = solid.mesh();
  for (Vec3& v : negative.vertices) v.x = v.x == 0 ? -0.0 : v.x;
  EXPECT_TRUE(audit(negative.view()).value().embedded());
}

/// A mesh that is the origin alone sets no scale of its own: the query's is all there is.
TEST(LostDigits, TinyQueriesRoundTheOriginAlone) {
  Mesh origin;
  origin.vertices = {{0, 0, 0}};
  origin.triangles = {{0, 0, 0}};
  const Field field = Field::build(origin.view()).value();
  for (const double size : {1.0, 1e-60, 1e-80, 1e-90, 1e-100, 1e-200, 1e-300}) {
    EXPECT_NEAR(field.distance({size, 0, 0}), size, 4 * test::ulp_of(size));
    EXPECT_NEAR(field.distance({0, -3 * size, 4 * size}), 5 * size, 4 * test::ulp_of(4 * size));
  }
}

TEST(LostDigits, BeyondTheRangeIsRefusedByName) {
  const Mesh good = test::block({{1, 1, 1}, {2, 2, 2}}).mesh();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nextafter(0x1p200, infinity), -1e61, 1e300, std::nextafter(0x1p-200, 0.0),
                           -1e-61, 5e-324, -1e-310, 1e-300}) {
    for (std::uint32_t vertex : {0U, 5U}) {
      Mesh mesh = good;
      mesh.vertices[vertex].y = bad;
      const Result<Field> field = Field::build(mesh.view());
      ASSERT_FALSE(field) << bad;
      EXPECT_EQ(field.error().code, Code::out_of_range);
      EXPECT_EQ(field.error().where, vertex);
      EXPECT_FALSE(field.error().text.empty());
      EXPECT_EQ(audit(mesh.view()).error().code, Code::out_of_range);
      EXPECT_EQ(BruteForce::over(mesh.view()).error().code, Code::out_of_range);
      EXPECT_EQ(weld(mesh, 0).error().code, Code::out_of_range);
      EXPECT_TRUE(std::isnan(closest_brute(mesh.view(), {0, 0, 0}).distance));
    }
  }
}

TEST(LostDigits, BothEndsOfTheRangeAreTaken) {
  for (const double good : {0x1p200, -0x1p200, 0x1p-200, -0x1p-200, 0.0, -0.0}) {
    Mesh mesh = test::block({{1, 1, 1}, {2, 2, 2}}).mesh();
    mesh.vertices[3].z = good;
    EXPECT_TRUE(Field::build(mesh.view())) << good;
  }
}

}  // namespace
}  // namespace cdfr
