// Surfaces whose truth is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contour/surface.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

constexpr Box brick{{0, 0, 0}, {1, 0.7, 0.4}};

Field field_of(const Mesh& mesh) { return Field::build(mesh.view()).value(); }

int count_at(const Mesh& mesh, const Vec3& place, double within) {
  return static_cast<int>(std::ranges::count_if(mesh.vertices, [&](const Vec3& v) {
    return std::max({std::fabs(v.x - place.x), std::fabs(v.y - place.y), std::fabs(v.z - place.z)}) <= within;
  }));
}

TEST(MeshOfBox, ShrunkHasItsEightCornersTwelveEdgesAndPlanes) {
  const Field field = field_of(test::box_mesh(brick));
  for (const double depth : {0.03, 0.1, 0.14}) {
    SCOPED_TRACE(depth);
    const ContourMesh contour = test::surface_of(field, -depth, 0.002);
    EXPECT_EQ(contour.report.undecided + contour.report.crowded + contour.report.loose, 0U);
    EXPECT_LT(contour.report.triangles, depth < 0.05 ? 8000U : 1500U);
    const Box inner{{depth, depth, depth}, {1 - depth, 0.7 - depth, 0.4 - depth}};
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 place{corner & 1 ? inner.hi.x : inner.lo.x, corner & 2 ? inner.hi.y : inner.lo.y,
                       corner & 4 ? inner.hi.z : inner.lo.z};
      EXPECT_EQ(count_at(contour.mesh, place, 1e-12), 1) << corner;
    }
    EXPECT_LE(test::largest_excess(field, contour.mesh, -depth, 20000), 1e-12);
    const double volume = (1 - 2 * depth) * (0.7 - 2 * depth) * (0.4 - 2 * depth);
    EXPECT_NEAR(test::volume_of(contour.mesh), volume, 1e-12);
  }
}

TEST(MeshOfBox, GrownIsRoundWithinTheTolerance) {
  const Field field = field_of(test::box_mesh(brick));
  const double grown = 0.1, tolerance = 0.01;
  const ContourMesh contour = test::surface_of(field, grown, tolerance);
  EXPECT_EQ(contour.report.undecided + contour.report.crowded + contour.report.loose, 0U);
  EXPECT_LE(test::largest_excess(field, contour.mesh, grown, 50000), tolerance);
  EXPECT_LE(test::largest_gap(field, contour.mesh, grown, tolerance * 2), tolerance);
  const double a = 1, b = 0.7, c = 0.4, pi = std::numbers::pi;
  const double volume = a * b * c + 2 * grown * (a * b + b * c + c * a) + pi * grown * grown * (a + b + c) +
                        4.0 / 3 * pi * grown * grown * grown;
  EXPECT_NEAR(test::volume_of(contour.mesh), volume, tolerance * 2 * (a * b + b * c + c * a));
}

TEST(MeshOfBox, TurnedKeepsItsCorners) {
  Mesh mesh = test::box_mesh({{-0.5, -0.35, -0.2}, {0.5, 0.35, 0.2}});
  // Columns of a rotation by the quaternion (1, 2, 3, 4) / sqrt(30).
  const auto turned = [](const Vec3& v) {
    return Vec3{(-20 * v.x + 4 * v.y + 22 * v.z) / 30, (20 * v.x - 10 * v.y + 20 * v.z) / 30,
                (10 * v.x + 28 * v.y + 4 * v.z) / 30};
  };
  for (Vec3& v : mesh.vertices) v = turned(v);
  const Field field = field_of(mesh);
  const double tolerance = 0.004, depth = 0.1;
  const ContourMesh contour = test::surface_of(field, -depth, tolerance);
  EXPECT_EQ(contour.report.loose, 0U);
  EXPECT_LE(test::largest_excess(field, contour.mesh, -depth, 50000), tolerance);
  EXPECT_LE(test::largest_gap(field, contour.mesh, -depth, tolerance * 2), tolerance);
  EXPECT_NEAR(test::volume_of(contour.mesh), 0.8 * 0.5 * 0.2, 1e-3);
}

TEST(MeshOfSphere, IsASphere) {
  const Field field = field_of(test::sphere_mesh(3));
  for (const double distance : {-0.4, 0.5}) {
    const ContourMesh contour = test::surface_of(field, distance, 0.03);
    EXPECT_EQ(contour.report.crowded + contour.report.loose, 0U);
    double least = 1e9, most = 0;
    for (const Vec3& v : contour.mesh.vertices) {
      const double radius = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
      least = std::min(least, radius);
      most = std::max(most, radius);
    }
    EXPECT_NEAR(least, 1 + distance, 0.05);
    EXPECT_NEAR(most, 1 + distance, 0.05);
    EXPECT_LE(test::largest_excess(field, contour.mesh, distance, 30000), 0.03);
    EXPECT_LE(test::largest_gap(field, contour.mesh, distance, 0.06), 0.03);
  }
}

TEST(MeshOfDistanceZero, IsThePartItself) {
  const Mesh mesh = test::box_mesh(brick);
  const ContourMesh contour = test::surface_of(field_of(mesh), 0, 0.01);
  EXPECT_TRUE(contour.report.part_itself);
  ASSERT_EQ(contour.mesh.triangles.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(contour.mesh.vertices[contour.mesh.triangles[i][k]], mesh.vertices[mesh.triangles[i][k]]);
  }
}

TEST(MeshOfDistanceZero, OfPartsThatCrossIsTheirUnion) {
  Mesh mesh = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  const Mesh other = test::box_mesh({{0.5, 0.4, 0.3}, {1.5, 1.4, 1.3}});
  for (const Triangle& t : other.triangles) mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  const Field field = field_of(mesh);
  ASSERT_FALSE(field.report().embedded());
  const ContourMesh contour = test::surface_of(field, 0, 0.1);
  EXPECT_FALSE(contour.report.part_itself);
  EXPECT_NEAR(test::volume_of(contour.mesh), 2 - 0.5 * 0.6 * 0.7, 0.05);
  EXPECT_LE(test::largest_excess(field, contour.mesh, 0, 20000), 0.1);
}

TEST(EmptyMesh, IsAnAnswer) {
  const Field field = field_of(test::box_mesh(brick));
  for (const double distance : {-0.21, -0.5, -100.0}) {
    const ContourMesh contour = test::surface_of(field, distance, 0.01);
    EXPECT_EQ(contour.report.triangles, 0U) << distance;
    EXPECT_EQ(contour.report.undecided, 0U) << distance;
  }
}

TEST(MeshOfPlate, AtHalfItsThicknessBoundsNothing) {
  const Field field = field_of(test::box_mesh({{0, 0, 0}, {1, 1, 0.1}}));
  const ContourMesh contour = test::surface_of(field, -0.05, 0.01);
  EXPECT_EQ(contour.report.triangles, 0U);
  EXPECT_GT(contour.report.undecided, 0U) << "rounding may have left a sheet, and that is said";
  // A sheet as thick as the deepest cells is found.
  const ContourMesh sheet = test::surface_of(field, -0.045, 0.01);
  EXPECT_NEAR(test::volume_of(sheet.mesh), 0.91 * 0.91 * 0.01, 1e-4);
}

}  // namespace
}  // namespace cdfr
