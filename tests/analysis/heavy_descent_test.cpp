// What is said of the depth in each heavy cell holds at any point of it, and nothing deep is in no cell.
#include "analysis/heavy_descent.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/cell_index.h"
#include "analysis/cut_cube.h"
#include "analysis/sections_case.h"
#include "cdfr/parts/part.h"
#include "field/leaves.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

HeavyCells cells_of(const Field& field, const Threshold& threshold) {
  HeavyCells cells;
  const Octree& tree = field.data().tree;
  const Run run;
  Progress progress(run);
  HeavyDescent descent(field.data(), threshold, cells, progress);
  for (std::size_t i = 0; i < tree.block_count(); ++i) {
    const Block block = tree.block(i);
    for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
      const LeafRecord& leaf = block.leaves[number];
      descent.run(cell, {block.entries.data() + leaf.first, leaf.count()}, leaf.side());
    });
  }
  return cells;
}

/// Among the deepest level's cells.
std::uint64_t place_of(const Lattice& lattice, const Vec3& x) {
  const double size = lattice.size(deepest_level);
  const auto along = [&](double v, double from) { return static_cast<std::uint32_t>((v - from) / size); };
  const Cell cell{deepest_level,
                  {along(x.x, lattice.origin.x), along(x.y, lattice.origin.y), along(x.z, lattice.origin.z)}};
  return Span::of(key_of(cell)).first;
}

void expect_bounds_hold(const Field& field, double depth, double error) {
  const Threshold threshold{depth, error, error / 2, 1e-12, !field.data().winding.empty()};
  const HeavyCells found = cells_of(field, threshold);
  const CellIndex index(found.cells);
  const Lattice& lattice = field.data().tree.lattice;
  test::Random random(5);
  std::size_t deep = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 x = random.in(field.bounds());
    const double own = -field.distance(x);
    const std::size_t at = index.at(place_of(lattice, x));
    if (at == CellIndex::none) {
      ASSERT_LE(own, depth + threshold.rounding) << "in no cell";
      continue;
    }
    const HeavyCell& cell = found.cells[at];
    const Vec3 c = centre_of(cell);
    const Vec3 y{(x.x - lattice.origin.x) / lattice.edge - c.x, (x.y - lattice.origin.y) / lattice.edge - c.y,
                 (x.z - lattice.origin.z) / lattice.edge - c.z};
    const double over = (own - depth) / lattice.edge, slack = 1e-12;
    ASSERT_LE(over, cell.at(y) + double{cell.above} + slack);
    if (!threshold.jumps) {
      ASSERT_GE(over, cell.at(y) - double{cell.below} - slack);
    }
    deep += own > depth;
  }
  EXPECT_GT(deep, 20U);
}

TEST(HeavyDescent, BoundsHold) {
  for (const double depth : {0.02, 0.3, 0.8})
    expect_bounds_hold(test::field_of(test::sphere_mesh(4)), depth, 0.02);
  expect_bounds_hold(test::field_of(test::box_mesh({{0, 0, 0}, {1, 2, 3}})), 0.3, 0.01);
  for (const char* name : {"tetrahedron", "one-tooth", "six-star"}) {
    const Field field = test::field_of(make_part(name).value());
    expect_bounds_hold(field, field.deepest().value().depth / 3, 0.02);
  }
  Mesh open = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  open.triangles.resize(10);
  expect_bounds_hold(test::field_of(open), 0.2, 0.02);
}

TEST(HeavyDescent, NothingLiesInThatIsMuchLessDeep) {
  const Field field = test::field_of(test::sphere_mesh(3));
  const double depth = 0.4, error = 0.03;
  const HeavyCells found = cells_of(field, {depth, error, error / 2, 1e-12, false});
  const Lattice& lattice = field.data().tree.lattice;
  for (const HeavyCell& cell : found.cells) {
    EXPECT_GT(-field.distance(lattice.centre(cell_of(cell.key))), depth - 2 * error);
  }
}

TEST(CutCube, IsTheShareOfManySamples) {
  test::Random random(3);
  const Box cube{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
  for (int k = 0; k < 40; ++k) {
    Vec3 way = random.in(cube);
    if (k % 4 == 1) way.x = 0;
    if (k % 8 == 2) way.x = way.y = 0;
    if (k % 8 == 3) way.x = way.y = way.z;
    const double offset = random.in(cube).x, hair = 1e-6;
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 y = random.in(cube);
      inside += offset + way.x * y.x + way.y * y.y + way.z * y.z > 0;
    }
    const CubeCut cut = cut_cube(way, offset, 0.5);
    EXPECT_NEAR(cut.volume, inside / 20000.0, 0.02);
    // The area is how the volume grows as the plane moves.
    const double length = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
    const double growth = cut_cube(way, offset + hair, 0.5).volume - cut_cube(way, offset - hair, 0.5).volume;
    EXPECT_NEAR(cut.area, growth / (2 * hair) * length, 1e-3);
  }
  EXPECT_EQ(cut_cube({1, 0, 0}, 1, 0.5).volume, 1);
  EXPECT_EQ(cut_cube({1, 0, 0}, -1, 0.5).volume, 0);
  EXPECT_EQ(cut_cube({0, 0, 0}, 1, 0.5).volume, 1);
}

}  // namespace
}  // namespace cdfr
