#include "tables/field_tables.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

#include "rounds.h"
#include "tables/measured_build.h"

namespace cdfr::bench {
namespace {

/// Longer ones are timed once.
constexpr double long_build = 5;
/// Beyond, the least lists would take longer than all the rest.
constexpr int most_resolution_for_least = 64;

struct Measured {
  MeasuredBuild last;
  Rounds seconds;
  std::optional<LeastLists> least;
};

CsvRow row_of(const FieldCase& which, Way way, const Measured& measured, bool timed) {
  const ListCounts& lists = measured.last.lists;
  CsvRow row{
      {"part", which.subject.name}, {"resolution", std::to_string(which.resolution)}, {"way", name_of(way)}};
  if (!measured.last.refused.empty()) {
    row.emplace_back("refused", measured.last.refused);
    return row;
  }
  row.insert(row.end(), {{"grid", lists.grid},
                         {"inside", fixed(lists.inside, 0)},
                         {"surface", fixed(lists.surface, 0)},
                         {"outside", fixed(lists.outside, 0)},
                         {"surface_mean", fixed(lists.surface_mean, 3)},
                         {"inside_mean", fixed(lists.inside_mean, 3)},
                         {"stated_kb", fixed(lists.stated_bytes / 1000, 1)}});
  if (timed) {
    row.emplace_back("real_mb", fixed(measured.last.bytes / 1e6, 3));
    row.emplace_back("build_ms", fixed(1000 * median(measured.seconds), 2));
    if (measured.least) {
      row.emplace_back("least_surface_mean", fixed(measured.least->surface_mean, 3));
      row.emplace_back("least_inside_mean", fixed(measured.least->inside_mean, 3));
    }
  }
  return row;
}

}  // namespace

Csv part_table() {
  Csv table;
  const auto add = [&](const Subject& subject, CsvRow row) {
    const std::optional<Mesh> mesh = mesh_of(subject);
    if (!mesh) return;
    const Field field = Field::build(mesh->view()).value();
    const Box box = field.bounds();
    // First where it is, then how deep to a thousandth of that.
    const Deepest deepest = field.deepest(field.deepest()->depth / 1000).value();
    row.insert(row.end(), {{"triangles", std::to_string(mesh->triangles.size())},
                           {"x", fixed(box.hi.x - box.lo.x, 3)},
                           {"y", fixed(box.hi.y - box.lo.y, 3)},
                           {"z", fixed(box.hi.z - box.lo.z, 3)},
                           {"depth", fixed(deepest.depth, 4)}});
    table.add(row);
  };
  for (const PaperPart& p : paper_parts()) {
    const auto known = [](double x) { return x > 0 ? fixed(x, 2) : ""; };
    add({p.name}, {{"part", p.name},
                   {"paper_triangles", p.triangles > 0 ? std::to_string(p.triangles) : ""},
                   {"paper_x", known(p.x)},
                   {"paper_y", known(p.y)},
                   {"paper_z", known(p.z)},
                   {"paper_depth", known(p.depth)}});
  }
  for (const Subject& subject : real_parts()) add(subject, {{"part", subject.name}});
  return table;
}

Csv field_table(const std::vector<FieldCase>& cases, int rounds) {
  Csv table;
  for (const FieldCase& which : cases) {
    const std::optional<Mesh> part = mesh_of(which.subject);
    if (!part) continue;
    std::fprintf(stderr, "field of %s %d\n", which.subject.name, which.resolution);
    const VoxelMesh mesh = in_voxels(*part, which.resolution);
    std::map<Way, Measured> measured;
    for (int round = 0; round < std::max(rounds, 1); ++round) {
      for (const Way way : all_ways) {
        Measured& own = measured[way];
        if (!own.seconds.empty() && own.seconds.front() >= long_build) continue;
        own.last = measured_build(way, mesh);
        own.seconds.push_back(own.last.seconds);
      }
    }
    if (rounds > 0 && which.resolution <= most_resolution_for_least) {
      measured[Way::octree_own].least = least_lists(build_octree(Way::octree_own, mesh).value());
    }
    for (const Way way : all_ways) table.add(row_of(which, way, measured[way], rounds > 0));
  }
  return table;
}

}  // namespace cdfr::bench
