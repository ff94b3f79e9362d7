// Negative inside, whatever the order of faces, the nesting, or a face that is there twice with both
// orientations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "cdfr/field/field.h"
#include "cdfr/mesh/flip.h"
#include "faults/block_solid.h"
#include "faults/promise.h"
#include "support/joined.h"

namespace cdfr {
namespace {

const Box unit{{0, 0, 0}, {1, 1, 1}};

Triangle turned(const Triangle& t) { return {t[0], t[2], t[1]}; }

TEST(SignConvention, NegativeInsideAndTheGradientPointsOut) {
  const test::BlockSolid solid({0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3},
                               [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; });
  const Field field = Field::build(solid.mesh().view()).value();
  EXPECT_EQ(field.distance({0.5, 1.5, 1.5}), -0.5);
  EXPECT_EQ(field.distance({-2, 1.5, 1.5}), 2);
  EXPECT_EQ(field.distance({1.5, 1.5, 1.5}), 0.5) << "the cavity is outside";
  EXPECT_EQ(field.closest({0.25, 1.5, 1.5}).gradient, (Vec3{-1, 0, 0}));
  EXPECT_EQ(field.closest({-0.25, 1.5, 1.5}).gradient, (Vec3{-1, 0, 0}));
  EXPECT_EQ(field.closest({0, 1.5, 1.25}).gradient, (Vec3{-1, 0, 0}));
  EXPECT_EQ(field.closest({1.25, 1.5, 1.5}).gradient, (Vec3{1, 0, 0}));
}

TEST(SignConvention, AMeshTurnedInsideOutIsToldAndTurnedBack) {
  Mesh mesh = test::block(unit).mesh();
  flip(mesh);
  const Field field = Field::build(mesh.view()).value();
  EXPECT_EQ(field.report().turned_shells, 1U);
  EXPECT_LT(field.report().volume, 0);
  EXPECT_FALSE(field.report().embedded());
  EXPECT_NE(sign_reason(field.report()).find("inside out"), std::string::npos);
  flip(mesh);
  EXPECT_EQ(mesh.triangles, test::block(unit).mesh().triangles);
  EXPECT_LT(Field::build(mesh.view()).value().distance({0.5, 0.5, 0.5}), 0);
}

TEST(SignConvention, EveryFaceThreeTimesTwoForwardOneReversed) {
  const test::BlockSolid solid = test::block({{0, 0, 0}, {1, 2, 3}});
  Mesh mesh = solid.mesh();
  for (const Triangle& t : solid.mesh().triangles) {
    mesh.triangles.push_back(turned(t));
    mesh.triangles.push_back(t);
  }
  const Field field = Field::build(mesh.view()).value();
  EXPECT_EQ(field.report().duplicate_triangles, 24U);
  EXPECT_TRUE(field.report().balanced());
  EXPECT_EQ(field.sign(), Sign::winding);
  test::expect_right(field, solid, 3000, 1);
}

TEST(SignConvention, OneFaceTwiceMoreWithBothOrientations) {
  const test::BlockSolid solid = test::block({{0, 0, 0}, {1, 2, 3}});
  for (std::size_t face = 0; face < 12; ++face) {
    Mesh mesh = solid.mesh();
    mesh.triangles.insert(mesh.triangles.begin(), turned(mesh.triangles[face]));
    mesh.triangles.push_back(turned(mesh.triangles.front()));
    const Field field = Field::build(mesh.view()).value();
    EXPECT_FALSE(field.report().embedded());
    test::expect_right(field, solid, 500, 2 + face);
  }
}

/// Both sides of a wall inside the part: the distance to it counts, its sides are both inside.
TEST(SignConvention, AnInnerWallOfTwoReversedFacesIsInside) {
  const Mesh box = test::block(unit).mesh();
  Mesh wall;
  wall.vertices = {{0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}, {0.25, 0.75, 0.5}};
  wall.triangles = {{0, 1, 2}, {0, 2, 1}};
  const Field field = Field::build(test::joined(box, wall).view()).value();
  EXPECT_EQ(field.distance({0.375, 0.375, 0.625}), -0.125);
  EXPECT_EQ(field.distance({0.375, 0.375, 0.4375}), -0.0625);
  EXPECT_EQ(field.distance({0.375, 0.375, 0.5}), 0);
  EXPECT_EQ(field.distance({0.375, 0.375, 2}), 1);
}

/// Every face with its reverse: nothing is inside, and the audit says so.
TEST(SignConvention, AllFacesReversedAsWellHoldNothing) {
  Mesh mesh = test::block(unit).mesh();
  Mesh reversed = mesh;
  flip(reversed);
  mesh = test::joined(mesh, reversed);
  const Field field = Field::build(mesh.view()).value();
  EXPECT_EQ(field.report().duplicate_triangles, 12U);
  EXPECT_EQ(field.report().volume, 0);
  test::Random random(3);
  for (int i = 0; i < 1000; ++i) ASSERT_GE(field.distance(random.in({{-1, -1, -1}, {2, 2, 2}})), 0);
}

TEST(SignConvention, TheOrderOfFacesAndCornersDoesNotTurnIt) {
  const test::BlockSolid solid({0, 1, 2}, {0, 1, 2}, {0, 1},
                               [](int i, int j, int) { return i == 0 || j == 0; });
  test::Random random(4);
  for (int round = 0; round < 5; ++round) {
    Mesh mesh = solid.mesh();
    for (std::size_t i = mesh.triangles.size(); i > 1; --i) {
      std::swap(mesh.triangles[i - 1], mesh.triangles[random.below(i)]);
      Triangle& t = mesh.triangles[i - 1];
      std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.below(3)), t.end());
    }
    test::expect_right(Field::build(mesh.view()).value(), solid, 500, 5);
  }
}

}  // namespace
}  // namespace cdfr
