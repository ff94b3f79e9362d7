#include "cdfr/mesh/audit.h"

#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "mesh/examine.h"

namespace cdfr {

std::string sign_reason(const MeshReport& report) {
  if (report.embedded()) return "closed, outward and embedded";
  std::string reason;
  const auto add = [&](std::uint64_t count, const char* one, const char* many) {
    if (count == 0) return;
    reason += (reason.empty() ? "" : ", ") + std::to_string(count) + " " + (count == 1 ? one : many);
  };
  add(report.open_edges, "open edge", "open edges");
  add(report.nonmanifold_edges, "non-manifold edge", "non-manifold edges");
  add(report.flipped_edges, "flipped edge", "flipped edges");
  add(report.nonmanifold_vertices, "non-manifold vertex", "non-manifold vertices");
  add(report.duplicate_triangles, "duplicate triangle", "duplicate triangles");
  add(report.touching_triangles, "triangle that touches or crosses others",
      "triangles that touch or cross others");
  add(report.turned_shells, "shell turned inside out or nested in another",
      "shells turned inside out or nested in others");
  return reason;
}

Result<MeshReport> audit(MeshView mesh, const Run& run) {
  const FloatingEnvironment environment;
  Progress progress(run);
  Result<MeshReport> report = Progress::error();
  with_threads(run, [&] {
    Result<Examined> examined = examine(mesh, progress);
    if (examined) {
      report = examined->report;
    } else {
      report = examined.error();
    }
  });
  return report;
}

}  // namespace cdfr
