// What a field takes from the mesh is the same in scratch files as on the heap.
#include <gtest/gtest.h>

#include <cstring>

#include "core/progress.h"
#include "field/sign.h"
#include "field/winding.h"
#include "mesh/examine.h"
#include "support/meshes.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

template <class T>
bool same_bytes(const Array<T>& a, const Array<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.bytes()) == 0);
}

class InScratch : public ScratchTest {};

TEST_F(InScratch, PseudonormalsAndWindingTreesAreTheSame) {
  const Scratch scratch(folder());
  Mesh open = test::sphere_mesh(6);
  open.triangles.resize(open.triangles.size() - 1000);
  for (const Mesh& mesh : {open, test::soup(3000, {{0, 0, 0}, {1, 1, 1}}, 3)}) {
    const cdfr::Run run;
    Progress progress(run);
    const Examined e = examine(mesh.view(), progress, &scratch).value();
    const std::size_t edges = e.topology.edges.size(), vertices = e.topology.vertex_count;
    const Pseudonormals on_heap = pseudonormals(e.triangles, edges, vertices, e.plain_edges, {});
    const Pseudonormals in_file = pseudonormals(e.triangles, edges, vertices, e.plain_edges, {}, &scratch);
    EXPECT_TRUE(same_bytes(in_file.edges, on_heap.edges));
    EXPECT_TRUE(same_bytes(in_file.vertices, on_heap.vertices));

    const WindingTree heap_tree = build_winding_tree(e.space(), edges);
    const WindingTree file_tree = build_winding_tree(e.space(), edges, &scratch);
    EXPECT_TRUE(same_bytes(file_tree.nodes, heap_tree.nodes));
    EXPECT_TRUE(same_bytes(file_tree.boundary.edges, heap_tree.boundary.edges));
    EXPECT_TRUE(same_bytes(file_tree.boundary.first, heap_tree.boundary.first));
    EXPECT_TRUE(same_bytes(file_tree.boundary.lengths, heap_tree.boundary.lengths));
    EXPECT_FALSE(file_tree.boundary.edges.empty());
  }
}

}  // namespace
}  // namespace cdfr
