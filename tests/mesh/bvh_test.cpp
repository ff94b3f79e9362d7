#include "mesh/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "geometry/box_distance.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

Mesh same_place(std::size_t count) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(count, {0, 1, 2});
  return mesh;
}

void expect_sound(const Mesh& mesh) {
  const BvhAndOrder tree = build_bvh(mesh.view());
  std::vector<std::uint32_t> sorted(tree.order.begin(), tree.order.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(sorted, all);
  for (std::uint32_t i = 0; i < tree.bvh.nodes.size(); ++i) {
    const BvhNode& node = tree.bvh.nodes[i];
    ASSERT_LT(node.first_group, node.end_group);
    if (!node.is_group()) {
      const BvhNode &left = tree.bvh.nodes[tree.bvh.left(i)], &right = tree.bvh.nodes[tree.bvh.right(i)];
      EXPECT_EQ(left.first_group, node.first_group);
      EXPECT_EQ(left.end_group, right.first_group);
      EXPECT_EQ(right.end_group, node.end_group);
      EXPECT_EQ(united(left.box, right.box), node.box);
      continue;
    }
    for (std::size_t slot = node.first_group * group_size;
         slot < std::min(node.end_group * group_size, tree.order.size()); ++slot) {
      for (const std::uint32_t v : mesh.triangles[tree.order[slot]])
        EXPECT_TRUE(contains(node.box, mesh.vertices[v]));
    }
  }
}

TEST(Bvh, HoldsEveryTriangleOnceInFullGroups) {
  for (const std::size_t count : {1U, 2U, 7U, 8U, 9U, 16U, 17U, 100U, 1000U}) {
    expect_sound(test::soup(count, {{0, 0, 0}, {1, 2, 3}}, count));
    EXPECT_EQ(build_bvh(test::soup(count, {{0, 0, 0}, {1, 2, 3}}, count).view()).bvh.nodes.size(),
              2 * ((count + 7) / 8) - 1);
  }
}

TEST(Bvh, TakesTrianglesAllInOnePlace) { expect_sound(same_place(20000)); }

TEST(Bvh, PathsStayShortOnAGeometricSeries) {
  // Each triangle is ten times as far out as the one before: splitting off one at a time looks cheapest.
  Mesh mesh;
  double size = 1e-50;
  for (std::uint32_t i = 0; i < 1500; ++i) {
    size *= 1.15;
    mesh.vertices.insert(mesh.vertices.end(), {{size, 0, 0}, {size, size, 0}, {size, 0, size}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Bvh bvh = build_bvh(mesh.view()).bvh;
  int deepest = 0;
  const auto walk = [&](const auto& self, std::uint32_t node, int depth) -> void {
    deepest = std::max(deepest, depth);
    if (bvh.nodes[node].is_group()) return;
    self(self, bvh.left(node), depth + 1);
    self(self, bvh.right(node), depth + 1);
  };
  walk(walk, 0, 1);
  EXPECT_LE(deepest, bvh_depth_limit);
}

}  // namespace
}  // namespace cdfr
