#include "field/build_field.h"

#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "field/domain.h"
#include "field/finished_block.h"
#include "mesh/examine.h"
#include "octree/build.h"
#include "octree/level_choice.h"
#include "octree/list_length.h"

namespace cdfr {
namespace {

/// With lists as long as the expected queries want them.
BuildOptions resolved(BuildOptions options, std::uint64_t triangles) {
  if (options.expected_queries > 0)
    options.max_triangles_per_leaf = list_length_for(triangles, options.expected_queries);
  options.expected_queries = 0;
  return options;
}

}  // namespace

std::optional<Error> refused(const BuildOptions& options) {
  const auto bad = [](const char* text) { return Error{Code::bad_option, 0, text}; };
  if (!(options.margin >= 0 && options.margin <= 1)) return bad("margin must be 0 to 1");
  if (options.max_triangles_per_leaf < 1) return bad("max_triangles_per_leaf must be at least 1");
  if (options.max_level != BuildOptions::automatic_level &&
      (options.max_level < 0 || options.max_level > deepest_level))
    return bad("max_level must be 0 to 18");
  if (!(options.gain > 0)) return bad("gain must be above 0");
  if (options.domain == Domain::band && !(options.band > 0 && options.band < HUGE_VAL))
    return bad("band must be positive and finite");
  if (options.domain == Domain::interior && options.sign == Sign::none)
    return bad("an unsigned field has no interior");
  return std::nullopt;
}

void derive_far_side(FieldData& field) noexcept {
  field.far_side = 0;
  if (field.sign == Sign::pseudonormal && field.report.closed())
    field.far_side = field.report.volume < 0 ? -1 : 1;
  if (field.sign == Sign::winding && field.report.balanced()) field.far_side = 1;
}

void lay_lattice(FieldData& field, const Scratch* scratch) {
  field.tree.lattice = lattice_for(field.bounds(), field.options.margin);
  int& level = field.options.max_level;
  if (level == BuildOptions::automatic_level)
    level = level_for(field.tree.lattice.edge, field.report.area, field.triangles.size());
  const Lattice& lattice = field.tree.lattice;
  Large<ScanGroup> groups(field.triangles.group_count(), scratch);
  for_chunks(groups.size(), 1024, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i)
      groups[i] =
          scan_group(field.triangles.group(static_cast<std::uint32_t>(i)), lattice.origin, lattice.edge);
  });
  field.scan_groups = std::move(groups);
}

Result<FieldData> prepare_field(MeshView mesh, const BuildOptions& options, Progress& progress,
                                const Scratch* scratch) {
  const FloatingEnvironment environment;
  Result<Examined> examined = examine(mesh, progress, scratch);
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
    field.pseudonormals =
        pseudonormals(field.triangles, examined->topology.edges.size(), field.report.vertices,
                      naive ? all : edges, naive ? all : vertices, scratch);
  }
  derive_far_side(field);
  if (field.sign == Sign::winding && !field.report.balanced())
    field.winding = build_winding_tree(field.space(), field.pseudonormals.edges.size(), scratch);
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
    lay_lattice(*field);
    BlockCut cut(field->space(), field->tree.lattice, field->options, progress, cells_left_out(*field));
    std::vector<FinishedBlock> blocks;
    const Result<void> built = finish_blocks(*field, cut, 0, progress, [&](FinishedBlock block) {
      blocks.push_back(std::move(block));
      return Result<void>();
    });
    if (built) take_blocks(*field, cut.octree(), std::move(blocks));
  });
  if (progress.cancelled()) return Progress::error();
  return field;
}

}  // namespace cdfr
