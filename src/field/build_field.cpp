#include "field/build_field.h"

#include <cmath>
#include <optional>
#include <utility>

#include "cdfr/mesh/audit.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "field/leaves.h"
#include "field/query.h"
#include "octree/build.h"

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

/// Gives each leaf that no surface crosses the side of its centre.
void set_sides(FieldData& field, Progress& progress) {
  if (field.sign == Sign::none) return;
  progress.phase(0.9, 1, static_cast<double>(field.tree.blocks.size()));
  for_chunks(field.tree.blocks.size(), 1, [&](std::size_t i, std::size_t) {
    Block& block = field.tree.blocks[i];
    for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
      LeafRecord& leaf = block.leaves[number];
      if (leaf.side() == Side::surface || progress.cancelled()) return;
      const bool inside = signed_distance(field, field.tree.lattice.centre(cell)) < 0;
      leaf.set(leaf.count(), inside ? Side::inside : Side::outside);
    });
    progress.step();
  });
}

}  // namespace

void index_leaves(FieldData& field) {
  field.first_leaf.assign(1, 0);
  for (const Block& block : field.tree.blocks) {
    field.first_leaf.push_back(field.first_leaf.back() + block.leaves.size());
  }
}

Result<FieldData> prepare_field(MeshView mesh, const BuildOptions& options) {
  const FloatingEnvironment environment;
  // The audit refuses what the arithmetic does not hold for: bad indices, coordinates out of range.
  const Result<MeshReport> report = audit(mesh);
  if (!report) return report.error();
  FieldData field;
  field.options = options;
  field.sign = options.sign;
  if (options.sign == Sign::automatic) field.sign = report->closed() ? Sign::pseudonormal : Sign::none;
  if (field.sign == Sign::pseudonormal && report->closed()) field.far_side = report->volume < 0 ? -1 : 1;
  field.vertices = report->vertices;
  const Topology topology = weld_topology(mesh);
  BvhAndOrder tree = build_bvh(mesh);
  field.bvh = std::move(tree.bvh);
  field.triangles = gather_triangles(mesh, topology, tree.order);
  if (field.sign == Sign::pseudonormal) field.pseudonormals = pseudonormals(topology, field.triangles);
  return field;
}

Result<FieldData> build_field(MeshView mesh, const BuildOptions& options, const Run& run) {
  if (std::optional<Error> error = refused(options)) return *error;
  const FloatingEnvironment environment;
  Progress progress(run);
  Result<FieldData> field = Progress::error();
  with_threads(run, [&] {
    field = prepare_field(mesh, options);
    if (!field) return;
    progress.phase(0.1, 0.2, 1);
    progress.step();
    const Lattice lattice = lattice_for(field->bounds(), options.margin);
    field->tree = build_octree(field->space(), lattice, options, progress);
    if (!progress.cancelled()) set_sides(*field, progress);
  });
  if (progress.cancelled()) return Progress::error();
  if (field) index_leaves(*field);
  return field;
}

}  // namespace cdfr
