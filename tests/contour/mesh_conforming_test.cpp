// A refinement that walks new leaves alone comes to what a walk over all leaves finds.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "contour/conforming.h"
#include "contour/surface.h"
#include "core/progress.h"
#include "geometry/query_range.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

/// A plate that grows from twice the depth asked for to a little more: its contour is a sheet, far thinner
/// than the tolerance at one end, which refinement follows cell by cell.
constexpr double depth = 0.1, tolerance = 0.04;

Field wedged_plate() {
  Mesh mesh = test::box_mesh({{0, 0, 0}, {1, 0.6, 2 * depth}});
  for (Vec3& v : mesh.vertices) {
    if (v.x > 0 && v.z > 0) v.z += 0.05;
    // Columns of a rotation by the quaternion (1, 2, 3, 4) / sqrt(30).
    v = {(-20 * v.x + 4 * v.y + 22 * v.z) / 30, (20 * v.x - 10 * v.y + 20 * v.z) / 30,
         (10 * v.x + 28 * v.y + 4 * v.z) / 30};
  }
  return Field::build(mesh.view()).value();
}

TEST(ConformingOfThinSheet, IsWhatAWalkOverAllLeavesFinds) {
  const Field field = wedged_plate();
  const FieldData& data = field.data();
  const SurfaceLattice lattice = surface_lattice(data.bounds(), depth, tolerance);
  const Sought sought{
      data, -depth, tolerance, {tolerance / 4, tolerance / 2, tolerance / 8}, point_rounding(4)};
  const cdfr::Run run;
  Progress progress(run);
  SurfaceLeaves leaves(sought, lattice);
  ASSERT_TRUE(leaves.descend(progress));
  const std::size_t at_first = leaves.leaves().size();
  Crossings crossings(sought, leaves.corners());
  Conforming conforming(leaves, crossings);
  ASSERT_TRUE(conforming.run(progress));
  const std::vector<SurfaceLeaf> refined = leaves.leaves();
  EXPECT_GT(refined.size(), at_first) << "there was nothing to refine";

  for (SurfaceLeaf& leaf : leaves.leaves()) leaf.sides.fill(no_index);
  Crossings anew(sought, leaves.corners());
  Conforming over_all(leaves, anew);
  ASSERT_TRUE(over_all.run(progress));
  ASSERT_EQ(leaves.leaves().size(), refined.size()) << "something was left to split";
  EXPECT_EQ(over_all.curves().faces().size(), conforming.curves().faces().size());
  for (std::uint32_t i = 0; i < refined.size(); ++i) {
    if (!refined[i].live) continue;
    for (std::size_t side = 0; side < cell_sides; ++side)
      ASSERT_EQ(refined[i].sides[side] == no_index, leaves.leaves()[i].sides[side] == no_index) << i;
    ASSERT_EQ(over_all.loops(i).size(), conforming.loops(i).size()) << i;
  }
}

TEST(ConformingOfThinSheet, GivesASurfaceThatHolds) {
  const Field field = wedged_plate();
  const ContourMesh contour = test::surface_of(field, -depth, tolerance);
  ASSERT_GT(contour.report.triangles, 0U);
  EXPECT_EQ(contour.report.loose, 0U);
  EXPECT_LE(test::largest_excess(field, contour.mesh, -depth, 20000), tolerance);
  EXPECT_LE(test::largest_gap(field, contour.mesh, -depth, tolerance, contour.report.places), tolerance);
}

}  // namespace
}  // namespace cdfr
