// The deepest point: known ones, and no sample of any part deeper than it is said.
#include <gtest/gtest.h>

#include <cmath>

#include "cdfr/field/field.h"
#include "cdfr/parts/part.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

Field field_of(const Mesh& mesh, const BuildOptions& options = {}) {
  return Field::build(mesh.view(), options).value();
}

/// The point is as deep as it says, and no point of many is deeper than the error allows.
Deepest checked(const Field& field, double error) {
  const Deepest deepest = field.deepest(error).value();
  EXPECT_EQ(-field.distance(deepest.point), deepest.depth);
  EXPECT_GE(deepest.error, 0);
  EXPECT_LE(deepest.error, error * (1 + 1e-9));
  test::Random random(11);
  for (int i = 0; i < 20000; ++i) {
    EXPECT_LE(-field.distance(random.in(field.bounds())), deepest.depth + deepest.error);
  }
  return deepest;
}

TEST(Deepest, OfABoxIsHalfItsThickness) {
  for (const double thickness : {1.0, 0.3, 0.03}) {
    const double error = thickness * 1e-4;
    const Deepest d = checked(field_of(test::box_mesh({{0, 0, 0.1}, {1, 1, 0.1 + thickness}})), error);
    EXPECT_NEAR(d.depth, thickness / 2, error);
  }
}

TEST(Deepest, OfASphereIsNearItsCentre) {
  const Deepest d = checked(field_of(test::sphere_mesh(4)), 1e-5);
  EXPECT_GT(d.depth, 0.99);
  EXPECT_LT(d.depth, 1);
}

TEST(Deepest, OfMadePartsIsNoShallowerThanAnySample) {
  for (const char* name : {"tetrahedron", "one-tooth", "six-star"}) {
    SCOPED_TRACE(name);
    checked(field_of(make_part(name).value()), 1e-3);
  }
  EXPECT_NEAR(checked(field_of(make_part("tetrahedron").value()), 1e-6).depth, 1 / (3 + std::sqrt(3)), 1e-6);
}

TEST(Deepest, IsTheSameAtAnyDepthOfTheOctreeAndForAnyDomain) {
  const Mesh mesh = make_part("six-star").value();
  const double depth = checked(field_of(mesh), 1e-4).depth;
  BuildOptions options;
  options.domain = Domain::interior;
  EXPECT_NEAR(checked(field_of(mesh, options), 1e-4).depth, depth, 1e-4);
  options = {};
  options.max_level = 0;
  EXPECT_NEAR(checked(field_of(mesh, options), 1e-4).depth, depth, 1e-4);
}

TEST(Deepest, IsTheSameForAnyNumberOfThreads) {
  const Field field = field_of(test::sphere_mesh(5));
  cdfr::Run run;
  run.threads = 1;
  const Deepest one = field.deepest(1e-4, run).value();
  run.threads = 2;
  const Deepest two = field.deepest(1e-4, run).value();
  EXPECT_EQ(one.point, two.point);
  EXPECT_EQ(one.depth, two.depth);
  EXPECT_EQ(one.error, two.error);
}

TEST(Deepest, OfAnOpenBoxEndsWhereItsSignDoes) {
  Mesh box = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  box.triangles.resize(10);  // without one side
  const Field field = field_of(box);
  ASSERT_EQ(field.sign(), Sign::winding);
  const Deepest d = field.deepest(0.02).value();
  EXPECT_EQ(-field.distance(d.point), d.depth);
  test::Random random(12);
  for (int i = 0; i < 5000; ++i) EXPECT_LE(-field.distance(random.in(field.bounds())), d.depth + d.error);
}

TEST(Deepest, OfWhatHasNoInsideIsZero) {
  Mesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {2, 1, 0}};
  EXPECT_EQ(field_of(sheet).deepest().value().depth, 0);
}

TEST(Deepest, RefusesByName) {
  const Field field = field_of(test::sphere_mesh(2));
  EXPECT_EQ(field.deepest(-1).error().code, Code::bad_option);
  EXPECT_EQ(field.deepest(NAN).error().code, Code::bad_option);
  BuildOptions options;
  options.sign = Sign::none;
  EXPECT_EQ(field_of(test::sphere_mesh(2), options).deepest().error().code, Code::not_closed);
  cdfr::Run run;
  run.tick = [](void*, double) noexcept { return false; };
  EXPECT_EQ(field.deepest(1e-9, run).error().code, Code::cancelled);
}

}  // namespace
}  // namespace cdfr
