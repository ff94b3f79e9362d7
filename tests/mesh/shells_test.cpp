// What the audit makes of closed bodies that meet, hold each other or are turned, and exact crossings.
#include <gtest/gtest.h>

#include "cdfr/mesh/audit.h"
#include "cdfr/mesh/flip.h"
#include "core/progress.h"
#include "mesh/crossings.h"
#include "mesh/examine.h"
#include "support/joined.h"
#include "support/meshes.h"
#include "support/winding.h"

namespace cdfr {
namespace {

const Box unit{{0, 0, 0}, {1, 1, 1}};

MeshReport report_of(const Mesh& mesh) { return audit(mesh.view()).value(); }

Mesh flipped(Mesh mesh) {
  flip(mesh);
  return mesh;
}

TEST(Shells, ASolidAndASolidWithACavityAreEmbedded) {
  EXPECT_TRUE(report_of(test::sphere_mesh(2)).embedded());
  const Mesh cavity = test::joined(test::sphere_mesh(2, 3), flipped(test::sphere_mesh(1, 1)));
  EXPECT_TRUE(report_of(cavity).embedded());
  EXPECT_EQ(report_of(cavity).sign(), Sign::pseudonormal);
  EXPECT_EQ(sign_reason(report_of(cavity)), "closed, outward and embedded");
}

TEST(Shells, InsideOutAndNestedWithoutACavityAreTurned) {
  const MeshReport turned = report_of(flipped(test::sphere_mesh(2)));
  EXPECT_TRUE(turned.closed());
  EXPECT_EQ(turned.turned_shells, 1U);
  EXPECT_EQ(turned.sign(), Sign::winding);
  const MeshReport nested = report_of(test::joined(test::sphere_mesh(2, 3), test::sphere_mesh(1, 1)));
  EXPECT_EQ(nested.turned_shells, 1U);
  EXPECT_EQ(nested.touching_triangles, 0U);
  EXPECT_FALSE(nested.embedded());
}

TEST(Shells, BodiesThatTouchOrCrossAreNotEmbedded) {
  const Mesh cube = test::box_mesh(unit);
  for (const Vec3 shift : {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0.5, 0.5, 0.5}, Vec3{1, 0.25, 0.25}}) {
    const MeshReport report = report_of(test::joined(cube, test::moved(cube, shift)));
    EXPECT_TRUE(report.balanced());
    EXPECT_FALSE(report.embedded()) << shift.x << ' ' << shift.y << ' ' << shift.z;
    EXPECT_NE(sign_reason(report), "closed, outward and embedded");
  }
  const MeshReport corner = report_of(test::joined(cube, test::moved(cube, {1, 1, 1})));
  EXPECT_EQ(corner.nonmanifold_vertices, 1U);
  EXPECT_FALSE(corner.embedded());
}

TEST(Shells, SidesAreWhatTheWindingNumberSays) {
  const Mesh overlap = test::joined(test::sphere_mesh(3), test::sphere_mesh(3, 1, {0.7, 0.1, 0.2}));
  const Mesh nested = test::joined(test::sphere_mesh(2, 3), test::sphere_mesh(2, 1));
  const Mesh inward = flipped(test::sphere_mesh(2));
  for (const Mesh& mesh : {overlap, nested, inward}) {
    const cdfr::Run run;
    Progress progress(run);
    const Examined examined = examine(mesh.view(), progress).value();
    int known = 0;
    for (std::uint32_t slot = 0; slot < examined.triangles.size(); ++slot) {
      const TriangleShape shape = examined.triangles.shape(slot);
      const Vec3 n = rounded(shape.normal);
      const auto& v = shape.vertices;
      const auto off = [&](double a) {
        return Vec3{(v[0].x + v[1].x + v[2].x) / 3 + a * n.x, (v[0].y + v[1].y + v[2].y) / 3 + a * n.y,
                    (v[0].z + v[1].z + v[2].z) / 3 + a * n.z};
      };
      const bool front = test::brute_winding(mesh.view(), off(1e-7)) > 0.5;
      const bool back = test::brute_winding(mesh.view(), off(-1e-7)) > 0.5;
      switch (examined.triangles.records[slot].sides) {
        case Sides::unknown:
          break;
        case Sides::outward:
          EXPECT_TRUE(!front && back);
          break;
        case Sides::both_inside:
          EXPECT_TRUE(front && back);
          break;
        case Sides::both_outside:
          EXPECT_TRUE(!front && !back);
          break;
      }
      known += examined.triangles.records[slot].sides != Sides::unknown;
    }
    EXPECT_GT(known, static_cast<int>(examined.triangles.size() * 3 / 4));
  }
}

TEST(Crossings, CountWindingsFromCornersOfTheLattice) {
  const Mesh cube = test::box_mesh({{0, 0, 0}, {4, 4, 4}});
  const Mesh twice = test::joined(cube, test::box_mesh({{1, 1, 1}, {3, 3, 3}}));
  const cdfr::Run run;
  Progress progress(run);
  const Examined examined = examine(twice.view(), progress).value();
  for (int i = 0; i < 9 * 9 * 9; ++i) {
    // Many of these are in the planes of faces, on the lines of edges, or on the surface itself.
    const Vec3 p{0.5 * (i % 9), 0.5 * (i / 9 % 9), 0.5 * (i / 81)};
    const int winding = winding_by_crossings(p, examined.space());
    const auto within = [&](double lo, double hi) {
      const auto at = [&](double x) { return x == lo || x == hi ? 0 : (x > lo && x < hi ? 1 : -1); };
      return std::min({at(p.x), at(p.y), at(p.z)});
    };
    const int outer = within(0, 4), inner = within(1, 3);
    if (outer == 0 || inner == 0) continue;
    EXPECT_EQ(winding, (outer > 0) + (inner > 0)) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

}  // namespace
}  // namespace cdfr
