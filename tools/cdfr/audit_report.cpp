#include "audit_report.h"

#include "number_text.h"
#include "settings.h"

namespace cdfr::command {
namespace {

struct Count {
  const char* key;
  const char* label;
  std::uint64_t MeshReport::*value;
};

constexpr Count counts[] = {
    {"triangles", "triangles", &MeshReport::triangles},
    {"vertices", "vertices", &MeshReport::vertices},
    {"open_edges", "open edges", &MeshReport::open_edges},
    {"nonmanifold_edges", "non-manifold edges", &MeshReport::nonmanifold_edges},
    {"flipped_edges", "flipped edges", &MeshReport::flipped_edges},
    {"unbalanced_edges", "unbalanced edges", &MeshReport::unbalanced_edges},
    {"nonmanifold_vertices", "non-manifold vertices", &MeshReport::nonmanifold_vertices},
    {"degenerate_triangles", "degenerate triangles", &MeshReport::degenerate_triangles},
    {"duplicate_triangles", "duplicate triangles", &MeshReport::duplicate_triangles},
    {"touching_triangles", "touching or crossing", &MeshReport::touching_triangles},
    {"components", "components", &MeshReport::components},
    {"turned_shells", "turned shells", &MeshReport::turned_shells},
};

}  // namespace

Json json_of(const MeshReport& report) {
  Json json;
  for (const Count& count : counts) json[count.key] = report.*count.value;
  json["closed"] = report.closed();
  json["embedded"] = report.embedded();
  json["volume"] = report.volume;
  json["area"] = report.area;
  json["sign"] = sign_text(report.sign());
  json["sign_text"] = sign_reason(report);
  return json;
}

void add_counts(const MeshReport& report, TextReport& text) {
  for (const Count& count : counts) text.line(count.label, count_text(report.*count.value));
}

std::vector<std::string> warnings_for(const MeshReport& report) {
  std::vector<std::string> warnings;
  if (report.closed() && report.volume < 0) {
    warnings.emplace_back("the volume is negative: normals point inward; --flip turns them");
  }
  if (!report.embedded()) {
    warnings.emplace_back(
        "not a closed, outward, embedded surface: inside is where it winds round a point more than "
        "half a time, and signed distances may jump off the surface");
  }
  return warnings;
}

void add_mesh(const MeshReport& report, TextReport& text) {
  text.line("mesh", sign_reason(report));
  if (report.touching_triangles > 0 || report.duplicate_triangles > 0)
    text.line("caution",
              "bodies cross or touch, and walls inside count as walls: the part may be thicker there");
}

}  // namespace cdfr::command
