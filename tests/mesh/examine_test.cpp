#include "mesh/examine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <vector>

#include "cdfr/mesh/flip.h"
#include "support/joined.h"
#include "support/meshes.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

/// Of types without padding.
template <class Values>
bool same_bytes(const Values& a, const Values& b) {
  static_assert(std::is_trivially_copyable_v<typename Values::value_type>);
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(*a.data())) == 0);
}

Mesh open_mesh() {
  Mesh mesh = test::sphere_mesh(6);
  for (std::size_t hole = 0; hole < 100; ++hole)
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(hole * 300));
  return mesh;
}

/// Triangles twice, turned over, collapsed, without area, and vertices that none uses.
Mesh dirty_mesh() {
  Mesh mesh = test::joined(open_mesh(), test::soup(500, {{-2, -2, -2}, {2, 2, 2}}, 7));
  for (std::size_t i = 0; i < 1000; ++i) mesh.triangles.push_back(mesh.triangles[7 * i]);
  for (std::size_t i = 0; i < 1000; ++i) std::swap(mesh.triangles[11 * i][0], mesh.triangles[11 * i][1]);
  for (std::uint32_t i = 0; i < 100; ++i) mesh.triangles.push_back({i, i, i + 1});
  mesh.vertices.insert(mesh.vertices.end(), {{5, 0, 0}, {6, 0, 0}, {7, 0, 0}, {9, 9, 9}});
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size() - 4);
  mesh.triangles.push_back({first, first + 1, first + 2});
  return mesh;
}

/// All triangles share one edge.
Mesh fan_mesh() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {0, 0, 1}};
  for (std::uint32_t i = 0; i < 1000; ++i) {
    mesh.vertices.push_back({1, static_cast<double>(i), 0});
    mesh.triangles.push_back({0, 1, i + 2});
  }
  return mesh;
}

class ExamineInScratch : public ScratchTest {
 protected:
  /// Reports, topology, tree and triangles are the same wherever they lie.
  void expect_same(const Mesh& mesh) {
    const Scratch scratch(folder());
    const cdfr::Run run;
    Progress progress(run);
    const Examined on_heap = examine(mesh.view(), progress).value();
    const Examined in_file = examine(mesh.view(), progress, &scratch).value();
    expect_same_report(in_file.report, on_heap.report);
    const Topology &a = in_file.topology, &b = on_heap.topology;
    EXPECT_EQ(a.vertex_count, b.vertex_count);
    EXPECT_TRUE(same_bytes(a.triangles, b.triangles));
    EXPECT_TRUE(same_bytes(a.edges_of, b.edges_of));
    EXPECT_TRUE(same_bytes(a.edges, b.edges));
    EXPECT_TRUE(std::ranges::equal(a.uses, b.uses, [](const Topology::Use& x, const Topology::Use& y) {
      return x.triangle == y.triangle && x.forward == y.forward;
    }));
    EXPECT_TRUE(same_bytes(in_file.bvh.nodes, on_heap.bvh.nodes));
    EXPECT_TRUE(same_bytes(in_file.triangles.exact, on_heap.triangles.exact));
    EXPECT_TRUE(same_bytes(in_file.triangles.records, on_heap.triangles.records));
    EXPECT_TRUE(same_bytes(in_file.plain_edges, on_heap.plain_edges));
    EXPECT_TRUE(same_bytes(in_file.plain_vertices, on_heap.plain_vertices));
    EXPECT_EQ(a.triangles.get_allocator().scratch(), &scratch);
    EXPECT_EQ(in_file.plain_edges.get_allocator().scratch(), &scratch);
    EXPECT_EQ(b.triangles.get_allocator().scratch(), nullptr);
  }

  static void expect_same_report(const MeshReport& a, const MeshReport& b) {
    static_assert(std::is_trivially_copyable_v<MeshReport>);
    EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
    EXPECT_EQ(sign_reason(a), sign_reason(b));
  }
};

TEST_F(ExamineInScratch, ClosedMeshesAreTheSame) {
  expect_same(test::sphere_mesh(6));
  expect_same(test::box_mesh({{0, 0, 0}, {1, 1, 1}}));
  Mesh inner = test::sphere_mesh(4, 0.5);
  flip(inner);
  expect_same(test::joined(test::sphere_mesh(5), inner));
}

TEST_F(ExamineInScratch, OpenMeshesAreTheSame) { expect_same(open_mesh()); }

TEST_F(ExamineInScratch, DirtyMeshesAreTheSame) {
  expect_same(dirty_mesh());
  expect_same(fan_mesh());
}

TEST_F(ExamineInScratch, TouchingMeshesAreTheSame) {
  expect_same(test::joined(test::sphere_mesh(5), test::sphere_mesh(5, 1, {0.7, 0.1, 0.2})));
  const Mesh cube = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  expect_same(test::joined(cube, test::moved(cube, {1, 0.25, 0.25})));
}

TEST_F(ExamineInScratch, AFolderThatIsMissingIsABadAllocation) {
  const Scratch missing(folder() / "missing");
  const cdfr::Run run;
  Progress progress(run);
  EXPECT_THROW((void)examine(test::sphere_mesh(6).view(), progress, &missing), std::bad_alloc);
}

}  // namespace
}  // namespace cdfr
