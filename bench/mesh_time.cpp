#include "mesh_time.h"

#include "cdfr/contour/mesh.h"
#include "processor_time.h"

namespace cdfr::bench {
namespace {

bool before_deadline(void* deadline, double) noexcept {
  return processor_seconds() < *static_cast<double*>(deadline);
}

}  // namespace

MeshTime mesh_time(const Field& field, double distance, double tolerance, double limit) {
  const double start = processor_seconds();
  double deadline = start + limit;
  const Run run{1, before_deadline, &deadline};
  const Result<ContourMesh> contour = contour_mesh(field, distance, {tolerance}, run);
  const double seconds = processor_seconds() - start;
  if (!contour && contour.error().code == Code::cancelled) return {0, "takes too long"};
  if (!contour) return {0, contour.error().text};
  const auto triangles = static_cast<double>(contour->report.triangles);
  if (triangles == 0) return {0, "has no triangles"};
  return {seconds * 1e6 / triangles, {}};
}

}  // namespace cdfr::bench
