#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "cdfr/field/field.h"
#include "field/field_data.h"
#include "field/query.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

const Box cube_box{{0, 0, 0}, {2, 2, 2}};

Field cube_field() { return Field::build(test::box_mesh(cube_box).view()).value(); }

TEST(Query, KnowsACube) {
  const Field field = cube_field();
  EXPECT_EQ(field.sign(), Sign::pseudonormal);
  EXPECT_EQ(field.distance({1, 1, 1}), -1);
  EXPECT_EQ(field.distance({1, 1, 2}), 0);
  EXPECT_EQ(field.distance({1, 1, 5}), 3);
  EXPECT_EQ(field.distance({5, 6, 1}), 5);
  EXPECT_EQ(field.distance({-2, -3, -6}), 7);
  const Closest face = field.closest({1.5, 0.75, 3});
  EXPECT_EQ(face.point, (Vec3{1.5, 0.75, 2}));
  EXPECT_EQ(face.gradient, (Vec3{0, 0, 1}));
  EXPECT_EQ(face.feature, Feature::face);
  const Closest corner = field.closest({-2, -3, -6});
  EXPECT_EQ(corner.point, (Vec3{0, 0, 0}));
  EXPECT_EQ(corner.feature, Feature::vertex);
  EXPECT_EQ(corner.triangle, 0U);
  EXPECT_NEAR(corner.gradient.z, -6.0 / 7, 1e-15);
}

TEST(Query, TiesGoToTheLowestTriangle) {
  const Field field = cube_field();
  EXPECT_EQ(field.closest({1, 1, 1}).triangle, 0U);
  Mesh doubled = test::box_mesh(cube_box);
  const Mesh once = doubled;
  doubled.triangles.insert(doubled.triangles.begin(), once.triangles.begin(), once.triangles.end());
  const Field twice = Field::build(doubled.view()).value();
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) EXPECT_LT(twice.closest(random.in({{-1, -1, -1}, {3, 3, 3}})).triangle, 12U);
}

TEST(Query, BruteForceLooksAwayOnlyFromLosers) {
  for (const Mesh& mesh : {test::box_mesh(cube_box), test::soup(150, {{0, 0, 0}, {1, 1, 1}}, 7),
                           test::soup(40, {{1e6, -1e6, 1e6}, {1e6 + 1, 1 - 1e6, 1e6 + 1}}, 8)}) {
    const Field field = Field::build(mesh.view()).value();
    const Box box = field.domain();
    test::Random random(4);
    for (int i = 0; i < 500; ++i) {
      const Vec3 p = i % 3 == 0 ? mesh.vertices[random.below(mesh.vertices.size())] : random.in(box);
      Race race(p, field.data().triangles, size_of(field.data(), p));
      for (std::uint32_t slot = 0; slot < field.data().triangles.size(); ++slot) race.challenge(slot);
      const Winner all = race.finding().winner, found = find_closest_brute(field.data(), p).winner;
      EXPECT_EQ(found.slot, all.slot);
      EXPECT_EQ(found.foot.squared, all.foot.squared);
    }
  }
}

TEST(Query, IsExactlyZeroOnTheSurfaceWithAUnitGradient) {
  const Field field = cube_field();
  test::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    Vec3 p = random.in(cube_box);
    const auto side = random.below(6);
    (side / 2 == 0 ? p.x : (side / 2 == 1 ? p.y : p.z)) = side % 2 == 0 ? 0 : 2;
    if (i % 3 == 0) (side / 2 == 0 ? p.y : p.x) = 2;
    const Closest c = field.closest(p);
    EXPECT_EQ(c.distance, 0);
    EXPECT_EQ(c.point, p);
    EXPECT_NEAR(std::hypot(c.gradient.x, c.gradient.y, c.gradient.z), 1, 1e-15);
  }
}

TEST(Query, NonFiniteGivesNaN) {
  const Field field = cube_field();
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const Vec3& p : {Vec3{nan, 0, 0}, Vec3{0, inf, 0}, Vec3{0, 0, -inf}}) {
    EXPECT_TRUE(std::isnan(field.distance(p)));
    EXPECT_TRUE(std::isnan(field.closest(p).distance));
    EXPECT_EQ(field.closest(p).triangle, no_index);
  }
}

TEST(Query, IsRightAtAnyDistance) {
  const Field field = cube_field();
  const BruteForce brute = BruteForce::over(test::box_mesh(cube_box).view()).value();
  for (const double away : {1e3, 1e9, 1e20, 1e80, 0x1p299, 1e100, 1e200, 1e300}) {
    EXPECT_DOUBLE_EQ(field.distance({away, 1, 1}), away - 2);
    EXPECT_DOUBLE_EQ(field.distance({1, -away, 1}), away);
    const Vec3 p{away, -away / 2, away / 4};
    EXPECT_TRUE(test::same_bits(field.closest(p), brute.closest(p)));
  }
  const double denormal = 5e-324;
  EXPECT_EQ(field.distance({1, 1, -denormal}), 0);
  EXPECT_EQ(field.distance({denormal, denormal, denormal}), 0);
}

/// Just inside the upper faces of a brick of eight cubes, x - origin rounds up to the end of the brick.
TEST(Query, IsRightAnUlpInsideTheDomain) {
  for (const Box& box : {Box{{-7.5, -0.5, -0.5}, {-0.5, 0.5, 0.5}}, Box{{-3.5, -0.5, -0.5}, {3.5, 0.5, 0.5}},
                         Box{{0.5, -0.5, -0.5}, {7.5, 0.5, 0.5}}}) {
    const Mesh mesh = test::box_mesh(box);
    BuildOptions options;
    options.max_triangles_per_leaf = 1;
    const Field field = Field::build(mesh.view(), options).value();
    const BruteForce brute = BruteForce::over(mesh.view()).value();
    const Box domain = field.domain();
    for (const double x : {std::nextafter(domain.hi.x, -9), domain.hi.x, std::nextafter(domain.hi.x, 9),
                           domain.lo.x, domain.hi.x - 1e-17}) {
      const Vec3 p{x, 0.1, 0.2};
      EXPECT_TRUE(test::same_bits(field.closest(p), brute.closest(p))) << x;
    }
  }
}

TEST(Query, DoesNotMindTheCallersRoundingMode) {
  const Field field = Field::build(test::sphere_mesh(3).view()).value();
  test::Random random(3);
  std::vector<Vec3> points;
  std::vector<Closest> expected;
  for (int i = 0; i < 300; ++i) {
    points.push_back(random.in({{-2, -2, -2}, {2, 2, 2}}));
    expected.push_back(field.closest(points.back()));
  }
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
    bool same = true;
    const Field rebuilt = Field::build(test::sphere_mesh(3).view()).value();
    for (std::size_t i = 0; i < points.size(); ++i)
      same &= test::same_bits(field.closest(points[i]), expected[i]);
    const bool kept = std::fegetround() == mode;
#if defined(__SSE2__)
    _mm_setcsr(0x1f80);
#endif
    std::fesetround(FE_TONEAREST);
    EXPECT_TRUE(same);
    EXPECT_TRUE(kept);
  }
}

TEST(Query, OneTriangleAndAllTrianglesInOnePoint) {
  Mesh one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  const Field single = Field::build(one.view()).value();
  EXPECT_EQ(single.sign(), Sign::winding);
  EXPECT_EQ(single.distance({0.25, 0.25, -2}), 2);
  Mesh heap;
  heap.vertices = {{3, 4, 0}};
  heap.triangles.assign(1000, {0, 0, 0});
  const Field point = Field::build(heap.view()).value();
  EXPECT_EQ(point.distance({0, 0, 0}), 5);
  EXPECT_EQ(point.closest({0, 0, 0}).triangle, 0U);
  EXPECT_EQ(point.distance({3, 4, 0}), 0);
  EXPECT_TRUE(std::isfinite(point.closest({3, 4, 0}).gradient.z));
}

TEST(Query, BuildRefusesByName) {
  const auto code = [](const Mesh& mesh, const BuildOptions& options = {}) {
    return Field::build(mesh.view(), options).error().code;
  };
  EXPECT_EQ(code({}), Code::empty_mesh);
  Mesh bad = test::box_mesh(cube_box);
  bad.triangles[3][1] = 8;
  EXPECT_EQ(code(bad), Code::bad_index);
  bad = test::box_mesh(cube_box);
  bad.vertices[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(bad), Code::not_finite);
  bad.vertices[2].y = 1e70;
  EXPECT_EQ(code(bad), Code::out_of_range);
  bad.vertices[2].y = 1e-70;
  EXPECT_EQ(code(bad), Code::out_of_range);
  const Mesh good = test::box_mesh(cube_box);
  BuildOptions options;
  options.max_level = 19;
  EXPECT_EQ(code(good, options), Code::bad_option);
  options = {};
  options.margin = -1;
  EXPECT_EQ(code(good, options), Code::bad_option);
  options = {};
  options.max_triangles_per_leaf = 0;
  EXPECT_EQ(code(good, options), Code::bad_option);
}

}  // namespace
}  // namespace cdfr
