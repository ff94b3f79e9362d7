#include "tables/scaling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cdfr/parts/part.h"
#include "processor_time.h"
#include "random.h"
#include "tables/measured_build.h"

namespace cdfr::bench {
namespace {

constexpr double most_triangles = 5.5e6;
constexpr int queries = 100000;
/// An octree's time for twice the resolution, at most by a way that splits all that has more than one
/// triangle.
constexpr double growth = 7;

/// Seconds that it took; infinite if it was refused, which is a row too.
double add_build(Csv& table, const std::string& part, int resolution, Way way, const VoxelMesh& mesh) {
  std::fprintf(stderr, "scaling: %s %d, %s\n", part.c_str(), resolution, name_of(way).c_str());
  const MeasuredBuild built = measured_build(way, mesh);
  CsvRow row{{"part", part}, {"resolution", std::to_string(resolution)}, {"way", name_of(way)}};
  if (!built.refused.empty()) {
    row.emplace_back("refused", built.refused);
    table.add(row);
    return HUGE_VAL;
  }
  row.insert(row.end(), {{"lists", fixed(built.lists.inside + built.lists.surface, 0)},
                         {"stated_mb", fixed(built.lists.stated_bytes / 1e6, 3)},
                         {"real_mb", fixed(built.bytes / 1e6, 3)},
                         {"build_ms", fixed(1000 * built.seconds, 2)}});
  table.add(row);
  return built.seconds;
}

/// Every triangle becomes four, by the middles of its sides, which neighbours share.
Mesh split(const Mesh& mesh) {
  Mesh finer;
  finer.vertices = mesh.vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(finer.vertices.size()));
    const Vec3 p = mesh.vertices[a], q = mesh.vertices[b];
    if (is_new) finer.vertices.push_back({p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2});
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.triangles.insert(finer.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return finer;
}

CsvRow triangle_row(const std::string& part, int splits, const Mesh& mesh) {
  std::fprintf(stderr, "scaling: %s, %zu triangles\n", part.c_str(), mesh.triangles.size());
  Run run;
  run.threads = 1;
  const double start = processor_seconds();
  const Field field = Field::build(mesh.view(), {}, run).value();
  const double seconds = processor_seconds() - start;
  const auto triangles = static_cast<double>(mesh.triangles.size());
  const auto bytes = static_cast<double>(field.stats().bytes);
  Random random(1);
  std::vector<Vec3> points(queries);
  for (Vec3& p : points) p = random.in(field.bounds());
  double sum = 0;
  const double asked = processor_seconds();
  for (const Vec3& p : points) sum += field.distance(p);
  const double query_s = processor_seconds() - asked;
  return {{"part", part},
          {"splits", std::to_string(splits)},
          {"triangles", fixed(triangles, 0)},
          {"real_mb", fixed(bytes / 1e6, 3)},
          {"build_ms", fixed(1000 * seconds, 2)},
          {"bytes_triangle", fixed(bytes / triangles, 0)},
          {"build_us_triangle", fixed(1e6 * seconds / triangles, 2)},
          {"query_ns", std::isfinite(sum) ? fixed(1e9 * query_s / queries, 0) : ""}};
}

double exponent(const std::vector<std::pair<double, double>>& points) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [size, cost] : points) {
    x += std::log(size);
    y += std::log(cost);
    xx += std::log(size) * std::log(size);
    xy += std::log(size) * std::log(cost);
  }
  const auto n = static_cast<double>(points.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

/// Fits `cost` over `size`, one law for each name that `series` gives; an empty name leaves the row out.
template <class Series>
void add_laws(Csv& laws, const Csv& table, const std::string& size, const std::string& cost, Series series) {
  std::map<std::string, std::vector<std::pair<double, double>>> points;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const double value = std::atof(table.at(row, cost).c_str());
    const std::string name = series(row);
    if (!name.empty() && value > 0) points[name].emplace_back(std::atof(table.at(row, size).c_str()), value);
  }
  for (const auto& [name, fitted] : points) {
    if (fitted.size() < 3) continue;
    const auto [least, greatest] = std::ranges::minmax(fitted);
    laws.add({{"what", name},
              {"cost", cost},
              {"over", size},
              {"from", fixed(least.first, 0)},
              {"to", fixed(greatest.first, 0)},
              {"exponent", fixed(exponent(fitted), 2)}});
  }
}

}  // namespace

Csv resolution_scaling(double most_seconds) {
  Csv table;
  for (const char* part : {"connector", "brevi"}) {
    const Mesh mesh = make_part(part).value();
    std::map<Way, double> expected;  ///< seconds of the next build
    for (int resolution = 32; resolution <= 4096; resolution *= 2) {
      const VoxelMesh voxels = in_voxels(mesh, resolution);
      for (const Way way : {Way::uniform, Way::octree_band, Way::octree_own, Way::octree}) {
        if (expected[way] > most_seconds) continue;
        const double took = add_build(table, part, resolution, way, voxels);
        expected[way] = way == Way::uniform && std::isfinite(took) ? 0 : growth * took;
      }
    }
  }
  return table;
}

Csv triangle_scaling() {
  Csv table;
  for (const char* part : {"cube", "connector", "brevi", "cylinder-head"}) {
    Mesh mesh = make_part(part).value();
    for (int splits = 0; splits <= 4; ++splits) {
      if (splits > 0) mesh = split(mesh);
      table.add(triangle_row(part, splits, mesh));
      if (4 * static_cast<double>(mesh.triangles.size()) > most_triangles) break;
    }
  }
  table.add(triangle_row("37 cylinder-heads", 0, make_part("cylinder-head", 37).value()));
  return table;
}

Csv power_laws(const Csv& by_resolution, const Csv& by_triangles) {
  Csv laws;
  for (const char* cost : {"lists", "real_mb", "build_ms"}) {
    add_laws(laws, by_resolution, "resolution", cost, [&](std::size_t row) {
      const bool coarse = std::atof(by_resolution.at(row, "resolution").c_str()) < 64;
      return coarse ? std::string() : by_resolution.at(row, "part") + ": " + by_resolution.at(row, "way");
    });
  }
  for (const char* cost : {"real_mb", "build_ms"}) {
    add_laws(laws, by_triangles, "triangles", cost, [&](std::size_t row) {
      return std::string(std::atof(by_triangles.at(row, "triangles").c_str()) < 1000 ? "" : "all parts");
    });
  }
  return laws;
}

}  // namespace cdfr::bench
