#include "store/arrays.h"

#include <algorithm>
#include <vector>

#include "field/build_field.h"

namespace cdfr {
namespace {

format::Settings settings_of(const FieldData& field) {
  format::Settings s;
  const Lattice& lattice = field.tree.lattice;
  s.origin[0] = lattice.origin.x;
  s.origin[1] = lattice.origin.y;
  s.origin[2] = lattice.origin.z;
  s.edge = lattice.edge;
  std::copy(lattice.bricks.begin(), lattice.bricks.end(), s.bricks);
  s.max_triangles_per_leaf = static_cast<std::uint32_t>(field.options.max_triangles_per_leaf);
  s.margin = field.options.margin;
  s.gain = field.options.gain;
  s.max_level = static_cast<std::uint32_t>(field.options.max_level);
  s.index_level = static_cast<std::uint32_t>(field.index.tables().grid_level);
  s.sign = static_cast<std::uint8_t>(field.sign);
  s.sign_option = static_cast<std::uint8_t>(field.options.sign);
  s.lists = static_cast<std::uint8_t>(field.options.lists);
  s.domain = static_cast<std::uint8_t>(field.options.domain);
  s.band = field.options.band;
  return s;
}

std::vector<format::Level> levels_of(const Octree& tree) {
  std::vector<format::Level> levels;
  for (const LevelStats& l : tree.levels)
    levels.push_back({l.cells, l.leaves, l.entries_in, l.entries_pruned, l.entries_kept});
  return levels;
}

std::vector<LevelStats> stats_of(const Array<format::Level>& levels) {
  std::vector<LevelStats> stats;
  for (const format::Level& l : levels) {
    stats.push_back({static_cast<int>(stats.size()), l.cells, l.leaves, l.entries_in, l.entries_pruned,
                     l.entries_kept, 0});
  }
  return stats;
}

void apply(const format::Settings& s, FieldData& field) {
  const auto small = [](std::uint32_t x) { return static_cast<int>(std::min(x, 0x7fffffffU)); };
  field.tree.lattice.origin = {s.origin[0], s.origin[1], s.origin[2]};
  field.tree.lattice.edge = s.edge;
  std::copy(std::begin(s.bricks), std::end(s.bricks), field.tree.lattice.bricks.begin());
  field.options.margin = s.margin;
  field.options.gain = s.gain;
  field.options.max_triangles_per_leaf = small(s.max_triangles_per_leaf);
  field.options.max_level = small(s.max_level);
  field.options.sign = static_cast<Sign>(s.sign_option);
  field.options.lists = static_cast<Lists>(s.lists);
  field.options.domain = static_cast<Domain>(s.domain);
  field.options.band = s.band;
  field.sign = static_cast<Sign>(s.sign);
}

}  // namespace

Arrays arrays_of(const FieldData& field, const std::string& unit) {
  const LeafIndex::Tables& index = field.index.tables();
  const Boundary& boundary = field.winding.boundary;
  return {std::vector{settings_of(field)},
          std::vector<char>(unit.begin(), unit.end()),
          std::vector{field.report},
          levels_of(field.tree),
          field.tree.top,
          field.tree.starts,
          index.grid,
          index.nodes,
          index.leaves,
          field.tree.entries,
          field.scan_groups,
          field.triangles.exact,
          field.triangles.records,
          field.bvh.nodes,
          field.pseudonormals.edges,
          field.pseudonormals.vertices,
          field.tree.nodes,
          field.tree.leaves,
          field.leaf_windings.whole,
          field.leaf_windings.place,
          field.leaf_windings.known,
          field.leaf_windings.near,
          field.winding.nodes,
          boundary.edges,
          boundary.first,
          boundary.lengths};
}

void take_arrays(const Arrays& a, FieldData& field) {
  apply(a.settings[0], field);
  field.report = a.report[0];
  field.triangles = {a.triangles, a.records};
  field.bvh.nodes = a.bvh_nodes;
  field.pseudonormals = {a.edge_normals, a.vertex_normals};
  field.winding = {a.winding_nodes, {a.boundary_edges, a.boundary_first, a.boundary_lengths}};
  field.scan_groups = a.scan_groups;
  field.leaf_windings = {a.windings, a.winding_places, a.known_windings, a.near_edges};
  Octree& tree = field.tree;
  tree.top = a.top;
  tree.nodes = a.block_nodes;
  tree.leaves = a.block_leaves;
  tree.entries = a.entries;
  tree.levels = stats_of(a.levels);
  tree.starts = a.block_starts;
  field.index = LeafIndex(
      tree, {static_cast<int>(a.settings[0].index_level), a.index_grid, a.index_nodes, a.index_leaves});
  derive_far_side(field);
}

}  // namespace cdfr
