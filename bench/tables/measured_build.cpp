#include "tables/measured_build.h"

#include "malloc_bytes.h"
#include "processor_time.h"

namespace cdfr::bench {
namespace {

template <class Build>
MeasuredBuild measure(Build build) {
  MeasuredBuild measured;
  const auto before = static_cast<double>(malloc_bytes());
  const double start = processor_seconds();
  const auto field = build();
  measured.seconds = processor_seconds() - start;
  if (!field) {
    measured.refused = field.error().text.substr(0, field.error().text.find(':'));
    return measured;
  }
  measured.bytes = static_cast<double>(malloc_bytes()) - before;
  measured.lists = lists_of(*field);
  return measured;
}

}  // namespace

MeasuredBuild measured_build(Way way, const VoxelMesh& mesh) {
  if (way == Way::uniform) return measure([&] { return build_uniform(mesh); });
  return measure([&] { return build_octree(way, mesh); });
}

}  // namespace cdfr::bench
