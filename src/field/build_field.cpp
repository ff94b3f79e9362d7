#include "field/build_field.h"

#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "field/leaves.h"
#include "field/query.h"
#include "geometry/box_distance.h"
#include "mesh/examine.h"
#include "octree/build.h"
#include "octree/list_length.h"

namespace cdfr {
namespace {

std::optional<Error> refused(const BuildOptions& options) {
  const auto bad = [](const char* text) { return Error{Code::bad_option, 0, text}; };
  if (!(options.margin >= 0 && options.margin <= 1)) return bad("margin must be 0 to 1");
  if (options.max_triangles_per_leaf < 1) return bad("max_triangles_per_leaf must be at least 1");
  if (options.max_level < 0 || options.max_level > deepest_level) return bad("max_level must be 0 to 18");
  if (!(options.gain > 0)) return bad("gain must be above 0");
  return std::nullopt;
}

/// With lists as long as the expected queries want them.
BuildOptions resolved(BuildOptions options, std::uint64_t triangles) {
  if (options.expected_queries > 0)
    options.max_triangles_per_leaf = list_length_for(triangles, options.expected_queries);
  options.expected_queries = 0;
  return options;
}

/// Gives each leaf that no triangle comes into the side that all of it is on, where that is certain. From the
/// block down: a cell that its centre's distance shows to be free of triangles answers for all of its leaves.
class SideSetter {
 public:
  SideSetter(const FieldData& field, Block& block, Progress& progress)
      : field_(field), block_(block), progress_(progress) {}

  void run() { visit(cell_of(block_.key), block_.nodes[0]); }

 private:
  void visit(const Cell& cell, TreeNode node) {
    if (!progress_.poll()) return;
    if (node.is_leaf() && block_.leaves[node.leaf_number()].side() == Side::surface) return;
    const Lattice& lattice = field_.tree.lattice;
    const Vec3 centre = lattice.centre(cell);
    const double radius = (diagonal_above(lattice.box(cell)) / 2 + 2 * lattice.grown()) * (1 + 0x1p-50);
    const bool free = node.is_leaf() || unsigned_distance(field_, centre) > radius * (1 + 0x1p-50);
    const Side side = free ? side_of(centre, radius) : Side::undecided;
    if (side != Side::undecided) return set_all(node, side);
    if (node.is_leaf()) return;
    for (int child = 0; child < 8; ++child) {
      visit(child_of(cell, child), block_.nodes[node.first_child() + static_cast<std::uint32_t>(child)]);
    }
  }

  /// Without boundary all of a free cell is where its centre is.
  Side side_of(const Vec3& centre, double radius) const noexcept {
    if (!field_.winding.empty()) return side_of_ball(field_.winding, field_.space(), centre, radius);
    return signed_distance(field_, centre) < 0 ? Side::inside : Side::outside;
  }

  void set_all(TreeNode node, Side side) noexcept {
    if (node.is_leaf()) {
      LeafRecord& leaf = block_.leaves[node.leaf_number()];
      return leaf.set(leaf.count(), side);
    }
    for (std::uint32_t child = 0; child < 8; ++child) set_all(block_.nodes[node.first_child() + child], side);
  }

  const FieldData& field_;
  Block& block_;
  Progress& progress_;
};

void set_sides(FieldData& field, Progress& progress) {
  const bool certain =
      field.sign == Sign::winding || (field.sign == Sign::pseudonormal && field.report.embedded());
  if (!certain) return;
  progress.phase(0.9, 1, static_cast<double>(field.tree.blocks.size()));
  for_chunks(field.tree.blocks.size(), 1, [&](std::size_t i, std::size_t) {
    SideSetter(field, field.tree.blocks[i], progress).run();
    progress.step();
  });
}

}  // namespace

void derive_sides(FieldData& field) {
  field.far_side = 0;
  if (field.sign == Sign::pseudonormal && field.report.closed())
    field.far_side = field.report.volume < 0 ? -1 : 1;
  if (field.sign == Sign::winding && field.report.balanced()) field.far_side = 1;
  if (field.sign == Sign::winding && !field.report.balanced()) {
    field.winding = build_winding_tree(field.space(), field.pseudonormals.edges.size());
  }
}

void index_leaves(FieldData& field) {
  field.first_leaf.assign(1, 0);
  for (const Block& block : field.tree.blocks) {
    field.first_leaf.push_back(field.first_leaf.back() + block.leaves.size());
  }
  field.index = LeafIndex(field.tree);
}

void derive_scan_groups(FieldData& field) {
  const Lattice& lattice = field.tree.lattice;
  field.scan_groups.resize(field.triangles.group_count());
  constexpr std::size_t chunk = 1024;
  for_chunks(field.scan_groups.size(), chunk, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      field.scan_groups[i] =
          scan_group(field.triangles.group(static_cast<std::uint32_t>(i)), lattice.origin, lattice.edge);
    }
  });
}

Result<FieldData> prepare_field(MeshView mesh, const BuildOptions& options, Progress& progress) {
  const FloatingEnvironment environment;
  Result<Examined> examined = examine(mesh, progress);
  if (!examined) return examined.error();
  FieldData field;
  field.options = resolved(options, mesh.triangles.size());
  field.report = examined->report;
  field.sign = options.sign == Sign::automatic ? field.report.sign() : options.sign;
  field.bvh = std::move(examined->bvh);
  field.triangles = std::move(examined->triangles);
  if (field.sign != Sign::none) {
    const bool naive = field.sign == Sign::pseudonormal;
    const std::span<const std::uint8_t> all, edges = examined->plain_edges,
                                             vertices = examined->plain_vertices;
    field.pseudonormals = pseudonormals(field.triangles, examined->topology.edges.size(),
                                        field.report.vertices, naive ? all : edges, naive ? all : vertices);
  }
  derive_sides(field);
  return field;
}

Result<FieldData> build_field(MeshView mesh, const BuildOptions& options, const Run& run) {
  if (std::optional<Error> error = refused(options)) return *error;
  const FloatingEnvironment environment;
  Progress progress(run);
  Result<FieldData> field = Progress::error();
  with_threads(run, [&] {
    field = prepare_field(mesh, options, progress);
    if (!field) return;
    progress.phase(0.1, 0.2, 1);
    progress.step();
    const Lattice lattice = lattice_for(field->bounds(), options.margin);
    field->tree = build_octree(field->space(), lattice, field->options, progress);
    if (progress.cancelled()) return;
    derive_scan_groups(*field);
    index_leaves(*field);
    set_sides(*field, progress);
    field->index.take_sides(field->tree);
    field->leaf_windings = leaf_windings(*field, progress);
  });
  if (progress.cancelled()) return Progress::error();
  return field;
}

}  // namespace cdfr
