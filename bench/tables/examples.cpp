#include "tables/examples.h"

#include <sys/mman.h>
#include <sys/resource.h>

#include <cstdio>
#include <new>
#include <optional>
#include <string>

#include "cdfr/contour/contour.h"
#include "cdfr/parts/part.h"
#include "cdfr/reference/uniform_contour.h"
#include "peak_memory.h"
#include "processor_time.h"
#include "tables/no_points.h"
#include "tables/subjects.h"
#include "tables/ways.h"

namespace cdfr::bench {
namespace {

struct Example {
  Subject part;
  const char* source;
  double depth = 0, tolerance = 0;  ///< in the part's unit, mm for made ones
  double paper_volume_gb = 0;       ///< of a plain volume of floats at that tolerance, as the paper reckons
  double paper_extraction_s = 0;
};

const Example head{{"cylinder-head"}, "huang-2001 5.5", 8.5, 0.137, 24, 0};
/// As deep and as fine for its size as the paper's: 8.5 of 9.5, and 0.137 of 480.
const Example real_head{{"head_res222", true}, "huang-2001 5.5", 0.211, 0.00133, 0, 0};
const Example engine{{"engine"}, "huang-2001-report 6", 10, 0.1, 180, 30};

/// What the child has to tell.
struct Told {
  double points = 0, field_s = 0, contour_s = 0, resident_mib = 0;
};

bool extract(const Example& example, Told& told) {
  const Run run = one_thread();
  const std::optional<Mesh> mesh = mesh_of(example.part);
  if (!mesh) return false;
  const double start = processor_seconds();
  const Field field = Field::build(mesh->view(), {}, run).value();
  told.field_s = processor_seconds() - start;
  NoPoints sink;
  const auto report = contour_points(field, -example.depth, {example.tolerance}, sink, run);
  told.contour_s = processor_seconds() - start - told.field_s;
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  told.resident_mib = static_cast<double>(usage.ru_maxrss) / 1024;
  if (report) told.points = static_cast<double>(report->points);
  return static_cast<bool>(report);
}

}  // namespace

Csv example_table() {
  Csv table;
  void* shared = ::mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return table;
  for (const Example& example : {head, real_head, engine}) {
    std::fprintf(stderr, "%s at %g\n", example.part.name, example.depth);
    Told& told = *new (shared) Told;
    if (!in_process([&] { return extract(example, told); }).done) continue;
    table.add(
        {{"source", example.source},
         {"part", example.part.name},
         {"depth", fixed(example.depth, 3)},
         {"tolerance", fixed(example.tolerance, 5)},
         {"points", fixed(told.points, 0)},
         {"field_ms", fixed(1000 * told.field_s, 0)},
         {"contour_ms", fixed(1000 * told.contour_s, 0)},
         {"peak_resident_mib", fixed(told.resident_mib, 0)},
         {"paper_plain_volume_gb", example.paper_volume_gb > 0 ? fixed(example.paper_volume_gb, 0) : ""},
         {"paper_contour_s", example.paper_extraction_s > 0 ? fixed(example.paper_extraction_s, 0) : ""}});
  }
  ::munmap(shared, sizeof(Told));
  return table;
}

Csv uniform_engine_table() {
  constexpr int resolution = 300;
  Csv table;
  std::fprintf(stderr, "engine by the papers' field of resolution %d\n", resolution);
  const VoxelMesh mesh = in_voxels(make_part(engine.part.name).value(), resolution);
  double start = processor_seconds();
  const Result<UniformField> field = build_uniform(mesh);
  if (!field) return table;
  const double field_s = processor_seconds() - start;
  UniformContourOptions options;
  options.tolerance = engine.tolerance / mesh.voxel;
  NoPoints sink;
  start = processor_seconds();
  const auto report = contour_points(*field, engine.depth / mesh.voxel, options, sink, one_thread());
  if (!report) return table;
  table.add({{"source", engine.source},
             {"part", engine.part.name},
             {"resolution", std::to_string(resolution)},
             {"stated_mb", fixed(static_cast<double>(field->stats().stated_bytes) / 1e6, 1)},
             {"points", fixed(static_cast<double>(report->points), 0)},
             {"field_ms", fixed(1000 * field_s, 0)},
             {"contour_ms", fixed(1000 * (processor_seconds() - start), 0)},
             {"paper_contour_s", fixed(engine.paper_extraction_s, 0)}});
  return table;
}

}  // namespace cdfr::bench
