#include "thickness_painted.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

#include "cdfr/export/painted.h"
#include "number_text.h"
#include "output_target.h"
#include "stop.h"
#include "unit.h"

namespace cdfr::command {
namespace {

constexpr std::size_t most_labels = 5;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Values {
  explicit Values(std::size_t size) : thickness(size, none), error(size, none), at_edge(size, none) {}
  void set(std::size_t i, const ThicknessSample& sample) {
    if (thickness[i] <= sample.thickness) return;
    thickness[i] = sample.thickness;
    error[i] = std::isnan(sample.thickness) ? none : sample.error;
    at_edge[i] = sample.at_edge ? 1 : 0;
  }
  std::vector<double> thickness, error, at_edge;
};

Values on_triangles(const Mesh& mesh, std::span<const ThicknessSample> samples) {
  Values values(mesh.triangles.size());
  for (const ThicknessSample& sample : samples) values.set(sample.triangle, sample);
  return values;
}

/// A vertex has the sample that lies where it does.
Values on_vertices(const Mesh& mesh, std::span<const ThicknessSample> samples) {
  std::map<std::array<double, 3>, std::size_t> at;
  const auto key = [](const Vec3& v) { return std::array{v.x, v.y, v.z}; };
  for (std::size_t i = 0; i < samples.size(); ++i) at[key(samples[i].position)] = i;
  Values values(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (const auto found = at.find(key(mesh.vertices[i])); found != at.end())
      values.set(i, samples[found->second]);
  }
  return values;
}

std::vector<PaintedLabel> labels_of(const ThicknessReport& report, const std::string& unit) {
  std::vector<PaintedLabel> labels;
  for (const ThinPlace& place : report.places) {
    if (labels.size() == most_labels || !place.is_wall()) break;
    labels.push_back({place.position, std::to_string(labels.size() + 1) + ": " +
                                          bounded_text(place.thickness, place.error + place.facet, unit)});
  }
  return labels;
}

}  // namespace

void write_thickness_painted(const ThicknessRequest& request, const Mesh& mesh, const std::string& unit,
                             const ThicknessFinding& finding) {
  const auto& samples = finding.walls.samples;
  const ThicknessReport& report = finding.walls.report;
  const bool by_vertex = request.options.at == SampleAt::vertices;
  const Values values = by_vertex ? on_vertices(mesh, samples) : on_triangles(mesh, samples);
  const ArrayPlace place = by_vertex ? ArrayPlace::vertex : ArrayPlace::face;
  PaintedMesh painted;
  painted.mesh = mesh.view();
  painted.arrays = {{"thickness", place, values.thickness},
                    {"error", place, values.error},
                    {"at_edge", place, values.at_edge}};
  painted.painted = "thickness";
  if (report.samples > 0) {
    painted.least = report.p1;
    painted.greatest = report.p99;
  }
  painted.unit = unit;
  painted.labels = labels_of(report, unit);
  painted.notes = lines_of(finding.provenance);
  const double metres = metres_in(unit).value_or(1);
  need(write_painted(painted, request.output, extension_of(request.output) == ".glb" ? metres : 1),
       request.output);
}

}  // namespace cdfr::command
