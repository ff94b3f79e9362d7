#include "store/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "field/boundary.h"
#include "field/leaves.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"
#include "geometry/unit_normal.h"

namespace cdfr {
namespace {

Error refusal(std::uint64_t where, const char* what) {
  return {Code::file_format, where, std::string(what) + " (element " + std::to_string(where) + ")"};
}

Result<void> check_lattice(const FieldData& field) {
  const Lattice& l = field.tree.lattice;
  int exponent = 0;
  const bool power = std::isfinite(l.edge) && l.edge > 0 && std::frexp(l.edge, &exponent) == 0.5;
  const bool sized = power && l.edge >= 0x1p-240 && l.edge <= 0x1p210;
  const double finest = sized ? std::ldexp(l.edge, -deepest_level) : 1;
  const auto placed = [&](double o) {
    return std::isfinite(o) && std::fabs(o) <= 0x1p201 && std::fmod(o, finest) == 0 &&
           std::fabs(o) <= finest * 0x1p53;
  };
  const bool bricked = l.bricks[0] - 1 < 8 && l.bricks[1] - 1 < 8 && l.bricks[2] - 1 < 8;  // 0 wraps round
  if (!sized || !bricked || !placed(l.origin.x) || !placed(l.origin.y) || !placed(l.origin.z)) {
    return refusal(0, "settings: lattice out of range");
  }
  const BuildOptions& o = field.options;
  if (!(o.margin >= 0 && o.margin <= 1 && o.gain > 0) || o.max_triangles_per_leaf < 1 || o.max_level < 0 ||
      o.max_level > deepest_level || field.sign == Sign::automatic || field.sign > Sign::none ||
      o.sign > Sign::none || o.lists > Lists::band) {
    return refusal(0, "settings: options out of range");
  }
  return {};
}

/// Normals are what the vertices say: signs and faces hang on them.
bool good_shape(const TriangleShape& shape) noexcept {
  for (const Vec3& v : shape.vertices) {
    if (!is_finite(v)) return false;
    for (const double c : {v.x, v.y, v.z}) {
      const double size = std::fabs(c);
      if (size != 0 && !(size >= smallest_coordinate && size <= largest_coordinate)) return false;
    }
  }
  return unit_normal(shape.vertices[0], shape.vertices[1], shape.vertices[2]) == shape.normal;
}

/// Ids point into the pseudonormals; only a collapsed edge has none.
bool good_ids(const FieldData& field, std::uint32_t slot) noexcept {
  const TriangleRecord& r = field.triangles.records[slot];
  const TriangleShape shape = field.triangles.shape(slot);
  for (int k = 0; k < 3; ++k) {
    const bool collapsed = shape.vertices[k] == shape.vertices[(k + 1) % 3];
    const bool edge = r.edges[k] == no_index ? collapsed : r.edges[k] < field.pseudonormals.edges.size();
    if (!edge || r.vertices[k] >= field.pseudonormals.vertices.size()) return false;
  }
  return true;
}

Result<void> check_triangles(const FieldData& field) {
  const TriangleStore& t = field.triangles;
  if (t.records.empty() || t.records.size() >= no_index || t.exact.size() != t.records.size()) {
    return refusal(0, "triangles: count does not fit the records");
  }
  for (std::uint32_t slot = 0; slot < t.size(); ++slot) {
    if (!good_shape(t.shape(slot))) return refusal(slot, "triangles: bad coordinate or normal");
  }
  std::vector<bool> met(t.records.size());
  for (std::uint32_t slot = 0; slot < t.size(); ++slot) {
    const std::uint32_t number = t.records[slot].number;
    if (number >= met.size() || met[number]) return refusal(slot, "records: bad number");
    if (t.records[slot].sides > Sides::both_outside) return refusal(slot, "records: bad sides");
    met[number] = true;
    if (field.sign != Sign::none && !good_ids(field, slot)) return refusal(slot, "records: bad id");
  }
  for (const auto* normals : {&field.pseudonormals.edges, &field.pseudonormals.vertices}) {
    for (std::size_t i = 0; i < normals->size(); ++i) {
      if (!is_finite((*normals)[i]) || largest_magnitude((*normals)[i]) > 0x1p20)
        return refusal(i, "pseudonormals: not finite");
    }
  }
  return {};
}

/// What the arrays show of the audit has to agree with it; the rest can only be believed.
Result<void> check_report(const FieldData& field) {
  const MeshReport& r = field.report;
  const bool agrees = r.triangles == field.triangles.records.size() && r.box == field.bvh.nodes[0].box &&
                      (field.sign == Sign::none || r.vertices == field.pseudonormals.vertices.size());
  // Crossings decide alone where every edge balances.
  const bool counted = field.sign != Sign::none && r.balanced();
  if (counted && !find_boundary(field.space(), field.pseudonormals.edges.size()).edges.empty())
    return refusal(0, "report: says that every edge balances");
  if (!agrees || !std::isfinite(r.volume) || !std::isfinite(r.area))
    return refusal(0, "report: does not fit the mesh");
  return {};
}

Box box_of(const TriangleStore& t, std::uint32_t group) noexcept {
  const std::uint32_t first = group * std::uint32_t{group_size};
  Box box{t.shape(first).vertices[0], t.shape(first).vertices[0]};
  for (std::uint32_t slot = first; slot < first + t.lanes(group); ++slot) {
    for (const Vec3& v : t.shape(slot).vertices) box = united(box, {v, v});
  }
  return box;
}

Result<void> check_bvh(const FieldData& field) {
  const Array<BvhNode>& nodes = field.bvh.nodes;
  const std::size_t groups = field.triangles.group_count();
  if (nodes.size() != 2 * groups - 1) return refusal(0, "bvh_nodes: count does not fit the groups");
  struct Expected {
    std::size_t node, first, end;
    int depth;
  };
  std::vector<Expected> stack{{0, 0, groups, 1}};
  while (!stack.empty()) {
    const Expected e = stack.back();
    stack.pop_back();
    const BvhNode& n = nodes[e.node];
    const Box& b = n.box;
    const bool boxed =
        is_finite(b.lo) && is_finite(b.hi) && b.lo.x <= b.hi.x && b.lo.y <= b.hi.y && b.lo.z <= b.hi.z;
    if (n.first_group != e.first || n.end_group != e.end || !boxed || e.depth > bvh_depth_limit) {
      return refusal(e.node, "bvh_nodes: bad range, box or depth");
    }
    if (n.is_group()) continue;
    const std::size_t middle = nodes[e.node + 1].end_group;
    if (middle <= e.first || middle >= e.end) return refusal(e.node + 1, "bvh_nodes: bad range");
    stack.push_back({e.node + 2 * (middle - e.first), middle, e.end, e.depth + 1});
    stack.push_back({e.node + 1, e.first, middle, e.depth + 1});
  }
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const auto node = static_cast<std::uint32_t>(i);
    const Box box = nodes[i].is_group()
                        ? box_of(field.triangles, nodes[i].first_group)
                        : united(nodes[field.bvh.left(node)].box, nodes[field.bvh.right(node)].box);
    if (!(box == nodes[i].box)) return refusal(i, "bvh_nodes: bad box");
  }
  const Box domain = field.tree.lattice.domain();
  if (!contains(domain, nodes[0].box.lo) || !contains(domain, nodes[0].box.hi)) {
    return refusal(0, "settings: the domain does not hold the mesh");
  }
  return {};
}

/// Walks a tree of nodes whose children must come after their parents; visit(cell, leaf number) may refuse a
/// leaf.
template <class Visit>
Result<void> check_tree(const std::vector<TreeNode>& nodes, const Cell& root, const char* what, Visit visit) {
  struct Pending {
    Cell cell;
    std::size_t node;
  };
  if (nodes.empty()) return refusal(0, what);
  std::vector<Pending> stack{{root, 0}};
  std::size_t met = 0;
  while (!stack.empty()) {
    const Pending at = stack.back();
    stack.pop_back();
    ++met;
    const TreeNode node = nodes[at.node];
    if (node.is_leaf()) {
      if (!visit(at.cell, node.leaf_number())) return refusal(at.node, what);
      continue;
    }
    const std::size_t first = node.first_child();
    if (first <= at.node || first + 8 > nodes.size() || at.cell.level >= deepest_level)
      return refusal(at.node, what);
    for (int child = 8; child-- > 0;)
      stack.push_back({child_of(at.cell, child), first + static_cast<std::size_t>(child)});
    if (met + stack.size() > nodes.size()) return refusal(at.node, what);
  }
  if (met != nodes.size()) return refusal(met, what);
  return {};
}

bool good_leaf(const FieldData& field, const Block& block, const LeafRecord& leaf) noexcept {
  if (leaf.count() == 0 || leaf.side() > Side::undecided) return false;
  if (std::uint64_t{leaf.first} + leaf.count() > block.entries.size()) return false;
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count(); ++i) {
    const Entry& entry = block.entries[i];
    if (!(entry.distance() >= 0) || (i > leaf.first && entry < block.entries[i - 1])) return false;
    const std::uint32_t number = entry.number();
    if (entry.is_group()) {
      if (number >= field.triangles.group_count()) return false;
      if ((entry.lanes() & ((1U << field.triangles.lanes(number)) - 1)) == 0) return false;
    } else if (number >= field.bvh.nodes.size() || entry.lanes() != 0xff) {
      return false;
    }
  }
  return true;
}

Result<void> check_blocks(const FieldData& field) {
  const Octree& tree = field.tree;
  std::size_t next_block = 0;
  Result<void> top =
      check_tree(tree.top, Cell{}, "top: bad tree", [&](const Cell& cell, std::uint32_t number) {
        if (number == Octree::no_block) return !tree.lattice.meets_brick(cell);
        return number < tree.blocks.size() && number == next_block++ && cell.level >= 0 &&
               tree.blocks[number].key == key_of(cell);
      });
  if (!top) return top;
  if (next_block != tree.blocks.size()) return refusal(next_block, "top: a block is missing");
  for (const Block& block : tree.blocks) {
    std::uint32_t next_leaf = 0;
    Result<void> good = check_tree(block.nodes, cell_of(block.key), "block_nodes: bad tree",
                                   [&](const Cell&, std::uint32_t number) {
                                     return number < block.leaves.size() && number == next_leaf++ &&
                                            good_leaf(field, block, block.leaves[number]);
                                   });
    if (!good) return good;
    if (next_leaf != block.leaves.size()) return refusal(next_leaf, "block_leaves: a leaf is missing");
  }
  return {};
}

/// One row a level, from 0 to the deepest level that has a leaf or deeper.
Result<void> check_levels(const FieldData& field) {
  const std::vector<LevelStats>& levels = field.tree.levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i].level != static_cast<int>(i)) return refusal(i, "levels: out of order");
  }
  int deepest = 0;
  for (const Block& block : field.tree.blocks) {
    for_each_leaf(block, [&](const Cell& cell, std::uint32_t) { deepest = std::max(deepest, cell.level); });
  }
  if (levels.size() <= static_cast<std::size_t>(deepest) || levels.size() > deepest_level + 1) {
    return refusal(levels.size(), "levels: count does not fit the leaves");
  }
  return {};
}

}  // namespace

Result<void> check_field(const FieldData& field) {
  for (const auto check :
       {check_lattice, check_triangles, check_bvh, check_report, check_blocks, check_levels}) {
    if (Result<void> good = check(field); !good) return good;
  }
  return {};
}

}  // namespace cdfr
