// Where the papers' extraction goes wrong: one made case each, with what cdfr does instead beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cdfr/contour/contour.h"
#include "cdfr/field/field.h"
#include "cdfr/parts/part.h"
#include "cdfr/reference/uniform.h"
#include "cdfr/reference/uniform_contour.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

UniformField uniform_of(const Mesh& mesh, int resolution) {
  UniformOptions options;
  options.resolution = resolution;
  return UniformField::build(mesh.view(), options).value();
}

double apart(const Vec3& a, const Vec3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/// sqrt(3)/2 s < E lets s exceed E, and a sheet along the axes then passes between the centres.
TEST(SubVoxelRule, LosesAnAxisAlignedSheetWhole) {
  const Mesh cube = make_part("cube").value();
  const UniformField uniform = uniform_of(cube, 40);
  ASSERT_EQ(uniform.voxel(), 0.125);
  UniformContourOptions options;
  options.tolerance = 0.12;
  EXPECT_EQ(contour_points(uniform, 0.625, options).value().size(), 0U);
  // The same sub-voxels, kept within half their diagonal: on either side of the sheet, 2 (30^3 - 28^3) at
  // most.
  options.keep = UniformKeep::half_diagonal;
  options.tolerance = 0.22;
  EXPECT_EQ(contour_points(uniform, 0.625, options).value().size(), 10816U);
  // At the tolerance that was asked for, and from the octree.
  options.tolerance = 0.12;
  EXPECT_GT(contour_points(uniform, 0.625, options).value().size(), 10816U);
  const Field field = Field::build(cube.view()).value();
  EXPECT_GT(contour_points(field, -0.625, {0.12}).value().size(), 5000U);
}

/// It is no matter of one exact depth: centres lie 0.125 apart and the rule reaches 0.06 to either side.
TEST(SubVoxelRule, LosesSheetsInAShareOfAllDepths) {
  const UniformField uniform = uniform_of(make_part("cube").value(), 40);
  UniformContourOptions options;
  options.tolerance = 0.12;
  for (const double beside : {-0.002, -0.001, 0.0, 0.001, 0.002}) {
    EXPECT_TRUE(contour_points(uniform, 0.625 + beside, options).value().empty()) << beside;
  }
  EXPECT_FALSE(contour_points(uniform, 0.63, options).value().empty());
  options.keep = UniformKeep::half_diagonal;
  for (double depth = 0.5625; depth < 0.6875; depth += 1.0 / 64) {
    EXPECT_FALSE(contour_points(uniform, depth, options).value().empty()) << depth;
  }
}

/// papers/huang-2001-report, section 3.4: all eight corners around the middle of a cube are at one depth, the
/// maximum is between them.
TEST(CornerTest, MissesAMaximumInsideACell) {
  const Mesh cube = make_part("cube").value();
  const UniformField uniform = uniform_of(cube, 6);
  UniformContourOptions options;
  options.tolerance = 0.1;
  options.regions = UniformRegions::inter_voxel;
  const double depth = 2.3;
  EXPECT_EQ(contour_points(uniform, depth, options).value().size(), 0U);
  options.regions = UniformRegions::voxels;
  const auto points = contour_points(uniform, depth, options).value();
  EXPECT_GT(points.size(), 0U);
  const Box box = Field::build(cube.view()).value().bounds();
  const Vec3 middle{(box.lo.x + box.hi.x) / 2, (box.lo.y + box.hi.y) / 2, (box.lo.z + box.hi.z) / 2};
  for (const ContourPoint& p : points) EXPECT_LT(apart(p.position, middle), 0.5);
  const Field field = Field::build(cube.view()).value();
  EXPECT_GT(contour_points(field, -depth, {0.1}).value().size(), 100U);
}

/// A plate thinner than a voxel has no two centres on both sides of a depth: all of its contour is lost.
TEST(CornerTest, MissesAWholeThinPlate) {
  const Mesh plate = test::box_mesh({{0, 0, 0.3}, {8, 8, 0.9}});
  const UniformField uniform = uniform_of(plate, 8);
  EXPECT_EQ(uniform.stats().inside_cells, 0U);
  UniformContourOptions options;
  options.tolerance = 0.1;
  options.regions = UniformRegions::inter_voxel;
  EXPECT_EQ(contour_points(uniform, 0.25, options).value().size(), 0U);
  options.regions = UniformRegions::voxels;
  EXPECT_GT(contour_points(uniform, 0.25, options).value().size(), 1000U);
}

/// papers/huang-2001, section 3.5: the nearest face says outside, another one inside: a contour in the air.
TEST(LeastPositive, FindsAContourOutsideThePart) {
  const Mesh cube = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  const UniformField uniform = uniform_of(cube, 4);
  const Field field = Field::build(cube.view()).value();
  UniformContourOptions options;
  options.tolerance = 0.05;
  const auto outside = [&](const std::vector<ContourPoint>& points) {
    return std::ranges::count_if(points,
                                 [&](const ContourPoint& p) { return field.distance(p.position) > 0; });
  };
  const auto closest = contour_points(uniform, 0.3, options).value();
  EXPECT_GT(closest.size(), 0U);
  EXPECT_EQ(outside(closest), 0);
  options.value = UniformValue::least_positive;
  const auto letter = contour_points(uniform, 0.3, options).value();
  EXPECT_GT(outside(letter), 0);
  EXPECT_EQ(letter.size(), closest.size() + static_cast<std::size_t>(outside(letter)));
}

/// An L: inside, past its inward edge, faces give outward normals and the edge gives inward vectors.
TEST(Normals, TurnRoundPastAnInwardEdge) {
  Mesh ell;
  for (const double z : {0.0, 2.0}) {
    ell.vertices.insert(ell.vertices.end(),
                        {{-2, -2, z}, {2, -2, z}, {2, 0, z}, {0, 0, z}, {0, 2, z}, {-2, 2, z}});
  }
  ell.triangles = {{0, 3, 1}, {1, 3, 2}, {0, 5, 3}, {3, 5, 4}, {6, 7, 9}, {7, 8, 9}, {6, 9, 11}, {9, 10, 11}};
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    ell.triangles.push_back({i, j, j + 6});
    ell.triangles.push_back({i, j + 6, i + 6});
  }
  const UniformField uniform = uniform_of(ell, 8);
  const Field field = Field::build(ell.view()).value();
  ASSERT_EQ(field.sign(), Sign::pseudonormal);
  const Vec3 before{-0.3, 0.01, 1}, past{-0.3, -0.01, 1};
  const Vec3 a = uniform.closest(before).normal, b = uniform.closest(past).normal;
  EXPECT_LT(uniform.distance(before), 0);
  EXPECT_LT(uniform.distance(past), 0);
  EXPECT_LT(a.x * b.x + a.y * b.y + a.z * b.z, -0.99);
  const Vec3 g = field.closest(before).gradient, h = field.closest(past).gradient;
  EXPECT_GT(g.x * h.x + g.y * h.y + g.z * h.z, 0.99);
}

}  // namespace
}  // namespace cdfr
