/// A field as what a file holds: arrays.
#pragma once

#include <cstdint>
#include <string>

#include "field/field_data.h"
#include "store/format.h"

namespace cdfr {

struct Arrays {
  Array<format::Settings> settings;
  Array<char> unit;
  Array<MeshReport> report;
  Array<format::Level> levels;
  Array<TreeNode> top;
  Array<BlockStart> block_starts;
  Array<TreeNode> index_grid, index_nodes;
  Array<LeafIndex::Leaf> index_leaves;
  Array<Entry> entries;
  Array<ScanGroup> scan_groups;
  Array<ExactTriangle> triangles;
  Array<TriangleRecord> records;
  Array<BvhNode> bvh_nodes;
  Array<Vec3> edge_normals, vertex_normals;
  Array<TreeNode> block_nodes;
  Array<LeafRecord> block_leaves;
  Array<std::int32_t> windings;
  Array<std::uint32_t> winding_places;
  Array<LeafWindings::Known> known_windings;
  Array<std::uint32_t> near_edges;
  Array<WindingMoments> winding_nodes;
  Array<BoundaryEdge> boundary_edges;
  Array<std::uint32_t> boundary_first;
  Array<double> boundary_lengths;
};

/// visit(section, array) for each but the checksums, in the file's order.
template <class Arrays, class Visit>
void for_each_array(Arrays& a, Visit visit) {
  visit(format::settings, a.settings);
  visit(format::unit, a.unit);
  visit(format::report, a.report);
  visit(format::levels, a.levels);
  visit(format::top, a.top);
  visit(format::block_starts, a.block_starts);
  visit(format::index_grid, a.index_grid);
  visit(format::index_nodes, a.index_nodes);
  visit(format::index_leaves, a.index_leaves);
  visit(format::entries, a.entries);
  visit(format::scan_groups, a.scan_groups);
  visit(format::triangles, a.triangles);
  visit(format::records, a.records);
  visit(format::bvh_nodes, a.bvh_nodes);
  visit(format::edge_normals, a.edge_normals);
  visit(format::vertex_normals, a.vertex_normals);
  visit(format::block_nodes, a.block_nodes);
  visit(format::block_leaves, a.block_leaves);
  visit(format::windings, a.windings);
  visit(format::winding_places, a.winding_places);
  visit(format::known_windings, a.known_windings);
  visit(format::near_edges, a.near_edges);
  visit(format::winding_nodes, a.winding_nodes);
  visit(format::boundary_edges, a.boundary_edges);
  visit(format::boundary_first, a.boundary_first);
  visit(format::boundary_lengths, a.boundary_lengths);
}

/// Shares what is large.
Arrays arrays_of(const FieldData& field, const std::string& unit);

/// The field of these arrays. Preconditions: settings and report have one element, there is a node of the
/// BVH.
void take_arrays(const Arrays& arrays, FieldData& field);

}  // namespace cdfr
