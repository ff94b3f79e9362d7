#include "cdfr/mesh/audit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/samples.h"

namespace cdfr {
namespace {

Mesh cube() {
  Mesh mesh;
  mesh.vertices = samples::cube_vertices();
  mesh.triangles = samples::cube_triangles();
  return mesh;
}

MeshReport report_of(const Mesh& mesh) { return audit(mesh.view()).value(); }

TEST(Audit, FaultsAreNamedWithTheirPlace) {
  Mesh mesh = cube();
  mesh.triangles[5][1] = 8;
  EXPECT_EQ(audit(mesh.view()).error().code, Code::bad_index);
  EXPECT_EQ(audit(mesh.view()).error().where, 5U);
  for (const auto& [x, code] :
       {std::pair{std::nan(""), Code::not_finite},
        std::pair{std::numeric_limits<double>::infinity(), Code::not_finite},
        std::pair{0x1p201, Code::out_of_range}, std::pair{-0x1p-201, Code::out_of_range}}) {
    mesh = cube();
    mesh.vertices[6].z = x;
    EXPECT_EQ(audit(mesh.view()).error().code, code);
    EXPECT_EQ(audit(mesh.view()).error().where, 6U);
  }
  EXPECT_EQ(audit({}).error().code, Code::empty_mesh);
}

TEST(Audit, CubeIsClosed) {
  const auto report = report_of(cube());
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.triangles, 12U);
  EXPECT_EQ(report.vertices, 8U);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.degenerate_triangles + report.duplicate_triangles + report.nonmanifold_vertices, 0U);
  EXPECT_EQ(report.volume, 1);
  EXPECT_EQ(report.area, 6);
  EXPECT_EQ(report.box, (Box{{0, 0, 0}, {1, 1, 1}}));
}

TEST(Audit, InsideOutHasNegativeVolume) {
  Mesh mesh = cube();
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  EXPECT_TRUE(report_of(mesh).closed());
  EXPECT_EQ(report_of(mesh).volume, -1);
}

TEST(Audit, VolumeIsAccurateFarFromTheOrigin) {
  Mesh mesh = cube();
  for (auto& p : mesh.vertices) p = {p.x + 0x1p40, p.y - 0x1p41, p.z + 0x1p39};
  EXPECT_EQ(report_of(mesh).volume, 1);
  EXPECT_EQ(report_of(mesh).area, 6);
  for (const double scale : {0x1p199, 0x1p-200}) {
    mesh = cube();
    for (auto& p : mesh.vertices) p = {p.x * scale, p.y * scale, p.z * scale};
    EXPECT_EQ(report_of(mesh).volume, scale * scale * scale);
  }
}

TEST(Audit, HolesFlipsAndFins) {
  Mesh hole = cube();
  hole.triangles.pop_back();
  EXPECT_EQ(report_of(hole).open_edges, 3U);
  Mesh flip = cube();
  std::swap(flip.triangles[0][0], flip.triangles[0][1]);
  EXPECT_EQ(report_of(flip).flipped_edges, 3U);
  EXPECT_FALSE(report_of(flip).closed());
  Mesh fin = cube();
  fin.vertices.push_back({3, 3, 3});
  fin.triangles.push_back({0, 1, 8});
  EXPECT_EQ(report_of(fin).nonmanifold_edges, 1U);
  EXPECT_EQ(report_of(fin).open_edges, 2U);
}

TEST(Audit, CollapsedTrianglesHaveNoEdges) {
  Mesh mesh = cube();
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({6, 6, 6});
  mesh.triangles.push_back({0, 0, 1});
  const auto report = report_of(mesh);
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.degenerate_triangles, 3U);
  EXPECT_EQ(report.duplicate_triangles, 0U);
  EXPECT_EQ(report.components, 1U);
}

TEST(Audit, ZeroAreaIsDecidedExactly) {
  Mesh mesh;
  // 0.1, 0.2, 0.3 are not in line once they are doubles; the first three points below are.
  mesh.vertices = {{1, 1, 1},     {2, 2, 2},     {3, 3, 3},
                   {0.1, 0.1, 0}, {0.2, 0.2, 0}, {0.3, std::nextafter(0.3, 1), 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(report_of(mesh).degenerate_triangles, 1U);
  EXPECT_GT(report_of(mesh).area, 0);
}

TEST(Audit, DuplicatesInAnyOrder) {
  Mesh mesh = cube();
  const Triangle t = mesh.triangles[3];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  mesh.triangles.push_back({t[0], t[2], t[1]});
  EXPECT_EQ(report_of(mesh).duplicate_triangles, 2U);
}

TEST(Audit, CubesThatTouchInAVertexHaveTwoFansThere) {
  Mesh mesh = cube();
  for (const auto& p : samples::cube_vertices()) mesh.vertices.push_back({p.x + 1, p.y + 1, p.z + 1});
  for (const auto& t : samples::cube_triangles()) mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  const auto report = report_of(mesh);
  EXPECT_EQ(report.nonmanifold_vertices, 1U);
  EXPECT_EQ(report.components, 2U);
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.volume, 2);
}

}  // namespace
}  // namespace cdfr
