#include "mesh/topology.h"

#include <gtest/gtest.h>

#include "mesh/samples.h"

namespace cdfr {
namespace {

TEST(Topology, WeldsByValueAndNumbersByFirstUse) {
  Mesh mesh;
  mesh.vertices = {{5, 5, 5}, {0.0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-0.0, 1, -0.0}, {1, 0, 0}, {2, 2, 2}};
  mesh.triangles = {{3, 1, 2}, {5, 4, 6}};
  const auto topology = weld_topology(mesh.view());
  EXPECT_EQ(topology.vertex_count, 4U);
  EXPECT_EQ(topology.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(topology.triangles[1], (Triangle{2, 1, 3}));
  EXPECT_EQ(topology.edges.size(), 5U);
}

TEST(Topology, EdgesKnowTheirUses) {
  Mesh mesh;
  mesh.vertices = samples::cube_vertices();
  mesh.triangles = samples::cube_triangles();
  const auto topology = weld_topology(mesh.view());
  ASSERT_EQ(topology.edges.size(), 18U);
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    const auto& edge = topology.edges[e];
    EXPECT_LT(edge.vertices[0], edge.vertices[1]);
    if (e > 0) {
      EXPECT_LT(topology.edges[e - 1].vertices, edge.vertices);
    }
    const auto uses = topology.uses_of(e);
    ASSERT_EQ(uses.size(), 2U);
    EXPECT_LT(uses[0].triangle, uses[1].triangle);
    EXPECT_NE(uses[0].forward, uses[1].forward);
  }
  for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& edge = topology.edges[topology.edges_of[t][k]];
      const auto from = topology.triangles[t][k], to = topology.triangles[t][(k + 1) % 3];
      EXPECT_EQ(edge.vertices, (std::array{std::min(from, to), std::max(from, to)}));
    }
  }
}

TEST(Topology, CollapsedEdgesAreNoEdges) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  mesh.triangles = {{0, 2, 1}, {0, 0, 2}};
  const auto topology = weld_topology(mesh.view());
  EXPECT_EQ(topology.vertex_count, 2U);
  ASSERT_EQ(topology.edges.size(), 1U);
  EXPECT_EQ(topology.edges_of[0], (Triangle{no_index, 0, 0}));
  EXPECT_EQ(topology.edges_of[1], (Triangle{no_index, no_index, no_index}));
  EXPECT_EQ(topology.uses_of(0).size(), 2U);
}

TEST(Topology, NothingComesOfNothing) {
  const auto topology = weld_topology({});
  EXPECT_EQ(topology.vertex_count, 0U);
  EXPECT_TRUE(topology.edges.empty());
}

}  // namespace
}  // namespace cdfr
