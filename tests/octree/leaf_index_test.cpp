#include "octree/leaf_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/topology.h"
#include "octree/built_octree.h"
#include "octree/made_octree.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

struct Walked {
  Cell cell;
  Block block;
  LeafRecord leaf;
};

/// From the virtual cube down; the upper half of a cell is from its centre on. An octree sees p as what it
/// is from the origin, rounded.
Walked walk(const Octree& tree, const Vec3& p) {
  const Vec3& o = tree.lattice.origin;
  const double at[3] = {p.x - o.x, p.y - o.y, p.z - o.z};
  Walked w;
  const Array<TreeNode>* nodes = &tree.top;
  TreeNode node = tree.top[0];
  for (;;) {
    if (node.is_leaf() && !w.block.nodes.empty()) break;
    if (node.is_leaf()) {
      w.block = tree.block(node.leaf_number());
      nodes = &w.block.nodes;
      node = (*nodes)[0];
      continue;
    }
    int child = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double half = tree.lattice.size(w.cell.level + 1);
      const double middle = (2 * w.cell.place[axis] + 1) * half;
      // Rounding may reach the brick's upper face: the last cell holds it.
      const bool last = at[axis] >= tree.lattice.bricks[axis] * tree.lattice.edge;
      if (last ? middle < tree.lattice.bricks[axis] * tree.lattice.edge : at[axis] >= middle) {
        child |= 1 << axis;
      }
    }
    w.cell = child_of(w.cell, child);
    node = (*nodes)[node.first_child() + static_cast<unsigned>(child)];
  }
  w.leaf = w.block.leaves[node.leaf_number()];
  return w;
}

/// Along one axis: anywhere from lo to hi, on a face of some level's cells, or a double beside one.
double coordinate(test::Random& random, double lo, double hi) {
  const double any = random.between(lo, hi), step = (hi - lo) / 8;
  const double face = lo + std::floor((any - lo) / step) * step;
  switch (random.below(7)) {
    case 0:
      return face;
    case 1:
      return std::nextafter(face, -HUGE_VAL);
    case 2:
      return std::nextafter(face, HUGE_VAL);
    case 3:
      return lo;
    case 4:
      return std::nextafter(lo, -HUGE_VAL);
    case 5:
      return std::nextafter(hi, lo);
    default:
      return any;
  }
}

/// A leaf of a random block, most often a deep one.
Box some_leaf(test::Random& random, const Octree& tree) {
  const Block block = tree.block(random.below(tree.block_count()));
  Cell cell = cell_of(block.key);
  for (TreeNode node = block.nodes[0]; !node.is_leaf();) {
    std::uint32_t child = static_cast<std::uint32_t>(random.below(8));
    for (int i = 0; i < 7 && block.nodes[node.first_child() + child].is_leaf(); ++i) child = (child + 1) % 8;
    cell = child_of(cell, static_cast<int>(child));
    node = block.nodes[node.first_child() + child];
  }
  return tree.lattice.box(cell);
}

Vec3 random_point(test::Random& random, const Octree& tree) {
  const Box d = tree.lattice.domain(), box = random.below(2) == 0 ? d : some_leaf(random, tree);
  const auto held = [](double x, double lo, double hi) { return std::clamp(x, lo, std::nextafter(hi, lo)); };
  return {held(coordinate(random, box.lo.x, box.hi.x), d.lo.x, d.hi.x),
          held(coordinate(random, box.lo.y, box.hi.y), d.lo.y, d.hi.y),
          held(coordinate(random, box.lo.z, box.hi.z), d.lo.z, d.hi.z)};
}

long double distance(const Vec3& a, const Vec3& b) {
  using Real = long double;
  return std::hypot(std::hypot(Real{a.x} - Real{b.x}, Real{a.y} - Real{b.y}), Real{a.z} - Real{b.z});
}

bool holds(const Box& cell, const Vec3& p, double grown) {
  return p.x >= cell.lo.x - grown && p.x <= cell.hi.x + grown && p.y >= cell.lo.y - grown &&
         p.y <= cell.hi.y + grown && p.z >= cell.lo.z - grown && p.z <= cell.hi.z + grown;
}

void check(const Octree& tree, test::Random& random, int points) {
  const LeafIndex index(tree);
  const Lattice& lattice = tree.lattice;
  for (int i = 0; i < points; ++i) {
    const Vec3 p = random_point(random, tree);
    ASSERT_TRUE(index.contains(p));
    const Walked expected = walk(tree, p);
    const LatticePoint place = index.place(p);
    const std::uint32_t number = index.leaf(place);
    const Located found = index.at(place, number);
    ASSERT_EQ(index.up(number), static_cast<std::uint32_t>(deepest_level - expected.cell.level));
    ASSERT_EQ(found.entries.data(), expected.block.entries.data() + expected.leaf.first);
    ASSERT_EQ(found.entries.size(), expected.leaf.count());
    ASSERT_EQ(found.side, expected.leaf.side());
    ASSERT_TRUE(holds(lattice.box(expected.cell), p, lattice.grown()));
    const long double from_centre = distance(p, lattice.centre(expected.cell)) / lattice.edge;
    ASSERT_GE(found.from_centre, from_centre);
    ASSERT_LE(found.from_centre, from_centre * (1 + 0x1p-48L) + 0x1p-47L);
  }
}

Octree built(const Mesh& mesh, const BuildOptions& options) {
  const BvhAndOrder ordered = build_bvh(mesh.view());
  const TriangleStore triangles = gather_triangles(mesh.view(), weld_topology(mesh.view()), ordered.order);
  const Lattice lattice = lattice_for(ordered.bvh.nodes[0].box, options.margin);
  return test::build_octree({triangles, ordered.bvh}, lattice, options);
}

TEST(LeafIndex, FindsTheLeafThatAWalkFinds) {
  test::Random random(1);
  for (int i = 0; i < 60; ++i) {
    const auto bricks = [&] { return static_cast<std::uint32_t>(1 + random.below(8)); };
    const Lattice lattice{{-0.75, 0.5, 0.25}, 0.5, {bricks(), bricks(), bricks()}};
    const int deepest = static_cast<int>(random.below(deepest_level + 1));
    check(test::OctreeMaker(random, lattice, deepest, 0.11).made(), random, 2000);
  }
}

TEST(LeafIndex, FindsItWhereCoordinatesHaveFewBitsForCells) {
  test::Random random(2);
  for (int i = 0; i < 40; ++i) {
    const double far = std::ldexp(1.0, 20 + static_cast<int>(random.below(15)));
    const Lattice lattice{{far, -far, 0}, 1, {2, 3, 1}};
    check(test::OctreeMaker(random, lattice, deepest_level, 0.124).made(), random, 2000);
  }
}

TEST(LeafIndex, FindsTheOneLeafOfLevelZero) {
  test::Random random(3);
  check(test::OctreeMaker(random, {{1, 2, 3}, 4, {1, 1, 1}}, 0, 1).made(), random, 2000);
}

TEST(LeafIndex, FindsLeavesInARowOfCubes) {
  test::Random random(4);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Lattice lattice{{-1, -1, -1}, 0.25, {1, 1, 1}};
    lattice.bricks[axis] = 8;
    for (int i = 0; i < 10; ++i) {
      check(test::OctreeMaker(random, lattice, 6, 0.12).made(), random, 2000);
      check(test::OctreeMaker(random, lattice, 0, 1).made(), random, 500);
    }
  }
}

TEST(LeafIndex, FindsLeavesOfASphere) {
  test::Random random(5);
  check(built(test::sphere_mesh(4), {}), random, 20000);
}

TEST(LeafIndex, FindsTheDeepLeavesOfASmallMesh) {
  BuildOptions options;
  options.gain = 1;
  options.max_level = 9;
  options.max_triangles_per_leaf = 4;
  const Octree tree = built(test::sphere_mesh(0), options);
  const auto deep = std::any_of(tree.levels.begin(), tree.levels.end(),
                                [](const LevelStats& l) { return l.level == 9 && l.leaves > 0; });
  EXPECT_TRUE(deep);
  test::Random random(6);
  check(tree, random, 20000);
}

TEST(LeafIndex, FindsTheDeepestLeavesAroundOnePoint) {
  BuildOptions options;
  options.gain = 1;
  options.max_level = deepest_level;
  options.max_triangles_per_leaf = 4;
  const Octree tree = built(test::sphere_mesh(0), options);
  const LeafIndex index(tree);
  test::Random random(7);
  for (int i = 0; i < 5000; ++i) {
    const double r = std::ldexp(1.0, -static_cast<int>(random.below(25)));
    const Vec3 p = random.in({{-r, -r, -r}, {r, r, r}});
    const LatticePoint place = index.place(p);
    const Walked expected = walk(tree, p);
    const Located found = index.at(place, index.leaf(place));
    ASSERT_EQ(found.entries.data(), expected.block.entries.data() + expected.leaf.first);
  }
}

TEST(LeafIndex, ContainsTheHalfOpenBrick) {
  test::Random random(8);
  const Octree tree = test::OctreeMaker(random, {{0, 0, 0}, 1, {1, 2, 3}}, 2, 0.2).made();
  const LeafIndex index(tree);
  EXPECT_TRUE(index.contains({0, 0, 0}));
  EXPECT_FALSE(index.contains({1, 0, 0}));
  EXPECT_FALSE(index.contains({0, 2, 0}));
  EXPECT_FALSE(index.contains({0, 0, 3}));
  EXPECT_FALSE(index.contains({std::nextafter(0, -1), 0, 0}));
}

TEST(LeafIndex, IsEmptyWithoutBlocks) {
  EXPECT_TRUE(LeafIndex().empty());
  EXPECT_TRUE(LeafIndex(Octree{}).empty());
}

}  // namespace
}  // namespace cdfr
