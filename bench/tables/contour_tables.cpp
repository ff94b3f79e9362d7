#include "tables/contour_tables.h"

#include <algorithm>
#include <cstdio>

#include "cdfr/contour/contour.h"
#include "cdfr/reference/uniform_contour.h"
#include "processor_time.h"
#include "tables/no_points.h"
#include "tables/ways.h"

namespace cdfr::bench {
namespace {

struct Extracted {
  double points = 0, evaluations = 0, seconds = 0;
};

constexpr double half_diagonal_of_unit = 0.8660254037844387;
/// The least of so many rounds; long ones are done once.
constexpr int rounds = 3;
constexpr double long_extraction = 2;

template <class Extract>
Extracted extract(Extract contour) {
  Extracted best;
  for (int round = 0; round < rounds; ++round) {
    NoPoints sink;
    const double start = processor_seconds();
    const auto report = contour(sink);
    const double seconds = processor_seconds() - start;
    if (!report) {
      std::fprintf(stderr, "bench: %s\n", report.error().text.c_str());
      return {};
    }
    if (round == 0 || seconds < best.seconds) {
      best = {static_cast<double>(report->points), static_cast<double>(report->evaluations), seconds};
    }
    if (seconds > long_extraction) break;
  }
  return best;
}

/// Of one part at one resolution of its fields. Lengths are in voxels.
class ContourRows {
 public:
  ContourRows(const ContourCase& which, const Mesh& part, int resolution, Csv& table)
      : which_(which), resolution_(resolution), mesh_(in_voxels(part, resolution)), table_(table) {
    const double share = which.depth / which.deepest;
    const Field standard = build_octree(Way::standard, mesh_).value();
    depth_ = which.subject.is_real ? share * standard.deepest().value().depth : which.depth / mesh_.voxel;
    rows(standard, name_of(Way::standard));
  }

  void of_octree() {
    const Field octree = build_octree(Way::octree, mesh_).value();
    rows(octree, name_of(Way::octree));
    for (const int fineness : which_.contour_resolutions) {
      const ContourOptions options{tolerance(fineness), Rule::paper};
      add(fineness, "octree-paper-rule", extract([&](PointSink& sink) {
            return contour_points(octree, -depth_, options, sink, one_thread());
          }));
    }
  }

  void of_uniform() {
    const Result<UniformField> uniform = build_uniform(mesh_);
    if (!uniform) return;
    for (const int fineness : which_.contour_resolutions) {
      UniformContourOptions options;
      options.tolerance = tolerance(fineness);
      add(fineness, name_of(Way::uniform), extract([&](PointSink& sink) {
            return contour_points(*uniform, depth_, options, sink, one_thread());
          }));
    }
  }

 private:
  /// The least that the papers' rule allows for sub-voxels of which `fineness` lie along the whole grid, so
  /// that a voxel has fineness / resolution of them on each edge: the grids whose points the papers counted
  /// (tables 5 to 7).
  double tolerance(int fineness) const {
    return half_diagonal_of_unit * (1 + 0x1p-20) * resolution_ / fineness;
  }

  void rows(const Field& field, const std::string& way) {
    for (const int fineness : which_.contour_resolutions) {
      const ContourOptions options{tolerance(fineness)};
      add(fineness, way, extract([&](PointSink& sink) {
            return contour_points(field, -depth_, options, sink, one_thread());
          }));
    }
  }

  void add(int fineness, const std::string& way, const Extracted& extracted) {
    const double points = std::max(extracted.points, 1.0);
    table_.add({{"part", which_.subject.name},
                {"depth", fixed(depth_ * mesh_.voxel, 4)},
                {"resolution", std::to_string(resolution_)},
                {"contour_resolution", std::to_string(fineness)},
                {"way", way},
                {"points", fixed(extracted.points, 0)},
                {"tolerance", fixed(tolerance(fineness) * mesh_.voxel, 5)},
                {"distances_point", fixed(extracted.evaluations / points, 2)},
                {"time_ms", fixed(1000 * extracted.seconds, 2)},
                {"us_point", fixed(1e6 * extracted.seconds / points, 4)}});
  }

  const ContourCase& which_;
  int resolution_;
  VoxelMesh mesh_;
  Csv& table_;
  double depth_ = 0;
};

}  // namespace

Csv contour_table(const std::vector<ContourCase>& cases) {
  Csv table;
  for (const ContourCase& which : cases) {
    const std::optional<Mesh> part = mesh_of(which.subject);
    if (!part) continue;
    for (const int resolution : which.field_resolutions) {
      std::fprintf(stderr, "contours of %s %d\n", which.subject.name, resolution);
      ContourRows rows(which, *part, resolution, table);
      rows.of_octree();
      rows.of_uniform();
    }
  }
  return table;
}

}  // namespace cdfr::bench
