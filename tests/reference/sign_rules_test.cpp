// The base triangle (papers/huang-2001, section 3.2): right at edges, wrong at vertices, and what rounding
// does to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "cdfr/contour/contour.h"
#include "cdfr/field/field.h"
#include "cdfr/mesh/audit.h"
#include "cdfr/parts/part.h"
#include "cdfr/reference/uniform.h"
#include "cdfr/reference/uniform_contour.h"
#include "support/random.h"

namespace cdfr {
namespace {

/// Lists everywhere around the mesh.
UniformField with_outside(const Mesh& mesh, int resolution) {
  UniformOptions options;
  options.resolution = resolution;
  options.border = resolution;
  options.keep_outside = true;
  return UniformField::build(mesh.view(), options).value();
}

/// Corners in an order that turns the faces outward.
Mesh tetrahedron(std::array<Vec3, 4> corners) {
  Mesh mesh;
  mesh.vertices.assign(corners.begin(), corners.end());
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  if (audit(mesh.view()).value().volume < 0) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

TEST(VertexRule, CallsAPointAboveASharpTipInside) {
  const Mesh tip = tetrahedron({{{0, 0, 0}, {10, 5, -9}, {10, -5, -9}, {10, 0, -1}}});
  const Field field = Field::build(tip.view()).value();
  ASSERT_EQ(field.sign(), Sign::pseudonormal);
  const Vec3 above{0, 0, 1};
  EXPECT_EQ(field.distance(above), 1);
  EXPECT_EQ(field.closest(above).feature, Feature::vertex);
  const UniformClosest paper = with_outside(tip, 8).closest(above);
  EXPECT_EQ(paper.distance, -1);
  EXPECT_EQ(paper.feature, Feature::vertex);
  EXPECT_EQ(paper.triangle, field.closest(above).triangle);
}

/// The paper's own tetrahedron has such tips, and its contour has ghosts outside them.
TEST(VertexRule, PutsPointsOutsideThePapersTetrahedron) {
  const Mesh part = make_part("tetrahedron").value();
  UniformOptions options;
  options.resolution = 12;
  const UniformField uniform = UniformField::build(part.view(), options).value();
  UniformContourOptions contour;
  contour.tolerance = 0.025;
  const Field field = Field::build(part.view()).value();
  const auto outside = [&](const std::vector<ContourPoint>& points) {
    return std::ranges::count_if(points,
                                 [&](const ContourPoint& p) { return field.distance(p.position) > 0; });
  };
  EXPECT_EQ(outside(contour_points(uniform, 0.08, contour).value()), 12);
  EXPECT_EQ(outside(contour_points(field, -0.08, {0.025}).value()), 0);
}

struct Tally {
  int edges = 0, edges_wrong = 0, vertices = 0, vertices_wrong = 0;
};

Tally compare_signs(const Mesh& mesh, test::Random& random, int points) {
  const Field field = Field::build(mesh.view()).value();
  EXPECT_EQ(field.sign(), Sign::pseudonormal);
  const UniformField uniform = with_outside(mesh, 3);
  const Box around = test::scaled(field.bounds(), 2);
  Tally tally;
  for (int i = 0; i < points; ++i) {
    const Vec3 p = random.in(around);
    if (!uniform.locate(p)) continue;
    const UniformClosest paper = uniform.closest(p);
    const double truth = field.distance(p);
    if (truth == 0 || paper.feature == Feature::face) continue;
    const bool wrong = (paper.distance < 0) != (truth < 0);
    (paper.feature == Feature::edge ? tally.edges : tally.vertices) += 1;
    (paper.feature == Feature::edge ? tally.edges_wrong : tally.vertices_wrong) += wrong;
  }
  return tally;
}

TEST(EdgeRule, IsRightWhereTheVertexRuleIsNot) {
  test::Random random(31);
  const Box unit{{0, 0, 0}, {1, 1, 1}};
  Tally total;
  for (int mesh = 0; mesh < 40; ++mesh) {
    const Tally one = compare_signs(
        tetrahedron({random.in(unit), random.in(unit), random.in(unit), random.in(unit)}), random, 300);
    total.edges += one.edges;
    total.edges_wrong += one.edges_wrong;
    total.vertices += one.vertices;
    total.vertices_wrong += one.vertices_wrong;
  }
  EXPECT_GT(total.edges, 3000);
  EXPECT_EQ(total.edges_wrong, 0);
  EXPECT_GT(total.vertices, 1000);
  EXPECT_GT(total.vertices_wrong, 0);
  RecordProperty("edges", total.edges);
  RecordProperty("vertices", total.vertices);
  RecordProperty("vertices_wrong", total.vertices_wrong);
}

/// A ridge of 2e-9: both products are the same double, so the lower number decides, which is the far face.
TEST(EdgeRule, DrownsInRoundingAtAKnifesEdge) {
  constexpr double h = 1e-9;
  Mesh knife;
  knife.vertices = {{0, 0, 0}, {1, 0, -h}, {1, 0, h}, {0, 1, 0}, {1, 1, -h}, {1, 1, h}};
  knife.triangles = {{0, 3, 4}, {0, 4, 1}, {0, 1, 2}, {3, 5, 4}, {0, 2, 5}, {0, 5, 3}, {1, 4, 5}, {1, 5, 2}};
  const Field field = Field::build(knife.view()).value();
  ASSERT_EQ(field.sign(), Sign::pseudonormal);
  const Vec3 before{-4e-12, 0.5, 1e-3};
  const UniformClosest paper = with_outside(knife, 8).closest(before);
  EXPECT_EQ(paper.feature, Feature::edge);
  EXPECT_GT(field.distance(before), 0) << "x < 0 is outside";
  EXPECT_LT(paper.distance, 0);
  EXPECT_EQ(-paper.distance, field.distance(before));
}

}  // namespace
}  // namespace cdfr
