#include "tables/ways.h"

#include "winners.h"

namespace cdfr::bench {
namespace {

/// Triangles and volume of leaves of one side.
struct Weighed {
  double triangles = 0, volume = 0;

  void add(const Leaf& leaf, std::size_t count) {
    const double edge = leaf.box.hi.x - leaf.box.lo.x, cube = edge * edge * edge;
    triangles += cube * static_cast<double>(count);
    volume += cube;
  }
  double mean() const { return volume > 0 ? triangles / volume : 0; }
};

double mean(std::uint64_t tuples, std::uint64_t cells) {
  return cells > 0 ? static_cast<double>(tuples) / static_cast<double>(cells) : 0;
}

}  // namespace

Run one_thread() {
  Run run;
  run.threads = 1;
  return run;
}

std::string name_of(Way way) {
  switch (way) {
    case Way::uniform:
      return "uniform";
    case Way::octree_band:
      return "octree-band";
    case Way::octree_own:
      return "octree-own";
    case Way::octree:
      return "octree";
    case Way::standard:
      return "default";
  }
  return "";
}

Result<UniformField> build_uniform(const VoxelMesh& mesh) {
  UniformOptions options;
  options.resolution = mesh.along;
  options.border = empty_voxels;
  options.surface_inherits = false;
  options.voxels = UniformVoxels::points;
  return UniformField::build(mesh.mesh.view(), options, one_thread());
}

Result<Field> build_octree(Way way, const VoxelMesh& mesh) {
  BuildOptions options;
  if (way != Way::standard) {
    options.margin = 0;
    options.domain = Domain::interior;
    options.max_level = mesh.level;
    options.max_triangles_per_leaf = way == Way::octree ? entry_triangles : 1;
    if (way != Way::octree) options.gain = 1;
    if (way == Way::octree_band) options.lists = Lists::band;
  }
  return Field::build(mesh.mesh.view(), options, one_thread());
}

ListCounts lists_of(const UniformField& field) {
  const UniformStats stats = field.stats();
  const auto [x, y, z] = field.counts();
  ListCounts lists;
  lists.grid = std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z);
  lists.inside = static_cast<double>(stats.inside_cells);
  lists.surface = static_cast<double>(stats.surface_cells);
  lists.outside = static_cast<double>(stats.outside_cells);
  lists.inside_mean = mean(stats.inside_tuples, stats.inside_cells);
  lists.surface_mean = mean(stats.surface_tuples, stats.surface_cells);
  lists.stated_bytes = static_cast<double>(stats.stated_bytes);
  return lists;
}

ListCounts lists_of(const Field& field) {
  ListCounts lists;
  Weighed inside, surface;
  double kept = 0;
  field.for_each_leaf([&](const Leaf& leaf) {
    ++kept;
    lists.stated_bytes += 4 * static_cast<double>(leaf.triangles.size()) + 5;
    lists.inside += leaf.side == Side::inside;
    lists.surface += leaf.side == Side::surface;
    if (leaf.side == Side::inside) inside.add(leaf, leaf.triangles.size());
    if (leaf.side == Side::surface) surface.add(leaf, leaf.triangles.size());
  });
  const double dropped = static_cast<double>(field.leaf_count()) - kept;
  lists.stated_bytes += dropped;
  lists.outside = dropped + kept - lists.inside - lists.surface;
  lists.inside_mean = inside.mean();
  lists.surface_mean = surface.mean();
  return lists;
}

LeastLists least_lists(const Field& field) {
  Weighed inside, surface;
  field.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.side != Side::inside && leaf.side != Side::surface) return;
    const std::size_t count = leaf.triangles.size() == 1 ? 1 : winners(field, leaf.box);
    (leaf.side == Side::inside ? inside : surface).add(leaf, count);
  });
  return {inside.mean(), surface.mean()};
}

}  // namespace cdfr::bench
