/// Contours as closed meshes: processor time a triangle on one thread, and what it is spent on.
///   bench_surfaces [--json FILE] [--models PART_OF_NAME] [--fineness N] [options of Google Benchmark]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "arguments.h"
#include "cdfr/contour/mesh.h"
#include "cdfr/field/field.h"
#include "models.h"
#include "rounds.h"
#include "table.h"

namespace cdfr::bench {
namespace {

/// Of this thread, which with one thread does all the work: other load on the machine does not count.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double longest_side(const Box& b) { return std::max({b.hi.x - b.lo.x, b.hi.y - b.lo.y, b.hi.z - b.lo.z}); }

/// Microseconds a triangle, of every surface that has some.
std::vector<double> measured;

/// Two distances inside, shares of the greatest depth, and two outside, shares of the longest side.
void surfaces(benchmark::State& state, const Model& model, double fineness) {
  const Result<Mesh> mesh = load_model(model);
  if (!mesh) return state.SkipWithError(mesh.error().text.c_str());
  const Field field = Field::build(mesh->view()).value();
  const double longest = longest_side(field.bounds());
  std::vector<double> distances{0.01 * longest, 0.04 * longest};
  if (field.sign() != Sign::none) {
    const double depth = field.deepest().value().depth;
    distances.insert(distances.begin(), {-0.5 * depth, -0.2 * depth});
  }
  const char* columns[] = {"inner_us", "outer_us", "near_us", "far_us"};
  double triangles = 0, cells = 0, evaluations = 0, seconds = 0;
  for ([[maybe_unused]] auto turn : state) {
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double start = processor_seconds();
      const Result<ContourMesh> surface =
          contour_mesh(field, distances[i], {longest / fineness}, {.threads = 1});
      const double taken = processor_seconds() - start;
      if (!surface) continue;  // an open mesh has no such surface
      const ContourMeshReport& report = surface->report;
      if (report.triangles == 0) continue;
      measured.push_back(taken * 1e6 / static_cast<double>(report.triangles));
      state.counters[columns[i + 4 - distances.size()]] = measured.back();
      seconds += taken;
      triangles += static_cast<double>(report.triangles);
      cells += static_cast<double>(report.cells);
      evaluations += static_cast<double>(report.evaluations);
    }
  }
  if (triangles == 0) return;
  state.counters["triangles"] = triangles;
  state.counters["us_triangle"] = seconds * 1e6 / triangles;
  state.counters["evaluations"] = evaluations / triangles;
  state.counters["cells"] = cells / triangles;
}

}  // namespace
}  // namespace cdfr::bench

int main(int count, char** arguments) {
  using namespace cdfr::bench;
  const std::string json = take_value(count, arguments, "--json");
  const std::string filter = take_value(count, arguments, "--models");
  const std::string fineness = take_value(count, arguments, "--fineness");
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  for (const Model& model : public_models(filter)) {
    benchmark::RegisterBenchmark(("surfaces/" + model.name).c_str(), [=](benchmark::State& state) {
      surfaces(state, model, fineness.empty() ? 512 : std::atof(fineness.c_str()));
    })->Iterations(1);
  }
  TableReporter table(
      {"triangles", "cells", "evaluations", "inner_us", "outer_us", "near_us", "far_us", "us_triangle"});
  const int status = table.run_and_report(json);
  if (!measured.empty())
    std::printf("\nmicroseconds a triangle, median    wanted <= 2   measured %.2f\n", median(measured));
  return status;
}
