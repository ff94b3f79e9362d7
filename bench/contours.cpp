/// Contours: time a point, distances a point, two threads, the source paper's way over the same leaves, and
/// time a triangle of the contour as a mesh.
///   bench_contours [--json FILE] [--models PART_OF_NAME] [--fineness N] [--rounds N]
///                  [--mesh-limit SECONDS] [options of Google Benchmark]
///   bench_contours --peak POINTS [--folder FOLDER]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "arguments.h"
#include "cdfr/contour/contour.h"
#include "cdfr/export/write.h"
#include "cdfr/field/field.h"
#include "mesh_time.h"
#include "models.h"
#include "papers_way.h"
#include "peak_memory.h"
#include "processor_time.h"
#include "rounds.h"
#include "table.h"

namespace cdfr::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double longest_side(const Box& b) { return std::max({b.hi.x - b.lo.x, b.hi.y - b.lo.y, b.hi.z - b.lo.z}); }

/// Counts, and reads what it is given.
class Counter final : public PointSink {
 public:
  Result<void> write(std::span<const ContourPoint> points) override {
    for (const ContourPoint& p : points) sum_ += p.position.x;
    benchmark::DoNotOptimize(sum_);
    return {};
  }

 private:
  double sum_ = 0;
};

struct Extracted {
  double seconds = 0, processor = 0;  ///< as the clock on the wall has it, and of processor time
  ContourReport report;
};

Extracted extract(const Field& field, double distance, const ContourOptions& options, unsigned threads,
                  int rounds) {
  Extracted best;
  for (int round = 0; round < rounds; ++round) {
    Counter sink;
    Run run;
    run.threads = threads;
    const auto start = Clock::now();
    const double processor_start = processor_seconds();
    best.report = contour_points(field, distance, options, sink, run).value();
    const double seconds = seconds_since(start), processor = processor_seconds() - processor_start;
    if (round == 0 || seconds < best.seconds) best.seconds = seconds;
    if (round == 0 || processor < best.processor) best.processor = processor;
  }
  return best;
}

/// By column, of every contour that has points.
std::map<std::string, std::vector<double>> measured;
/// Contours without a figure in the mesh column, and why.
std::vector<std::string> left_out;

struct Options {
  double fineness = 1024;  ///< longest side by tolerance of points; that of meshes is twice as large
  double mesh_limit = 60;  ///< seconds for a mesh
  int rounds = 3;          ///< of which the least counts
};

/// Contours at two depths, shares of the greatest, and two distances outside, shares of the longest side.
void contours(benchmark::State& state, const Model& model, const Options& asked) {
  const Result<Mesh> mesh = load_model(model);
  if (!mesh) return state.SkipWithError(mesh.error().text.c_str());
  const Field field = Field::build(mesh->view()).value();
  const double longest = longest_side(field.bounds());
  const ContourOptions options{longest / asked.fineness};
  std::vector<double> distances{0.01 * longest, 0.04 * longest};
  if (field.sign() != Sign::none) {
    const double depth = field.deepest().value().depth;
    distances.insert(distances.begin(), {-0.5 * depth, -0.2 * depth});
  }
  std::map<std::string, std::vector<double>> own;
  for ([[maybe_unused]] auto turn : state) {
    for (const double distance : distances) {
      const Extracted one = extract(field, distance, options, 1, asked.rounds);
      const Extracted two = extract(field, distance, options, 2, asked.rounds);
      const auto points = static_cast<double>(one.report.points);
      if (points == 0) continue;
      own["points"].push_back(points);
      own["ns_point"].push_back(one.processor * 1e9 / points);
      own["evaluations"].push_back(static_cast<double>(one.report.evaluations) / points);
      own["two_threads"].push_back(one.seconds / two.seconds);
      own["papers_way"].push_back(papers_way_seconds(field, *mesh, distance, options.tolerance) /
                                  one.processor);
      const MeshTime mesh_took = mesh_time(field, distance, 2 * options.tolerance, asked.mesh_limit);
      if (mesh_took.left_out.empty()) {
        own["mesh_us_triangle"].push_back(mesh_took.us_triangle);
      } else {
        left_out.push_back(model.name + " at " + std::to_string(distance) + ": " + mesh_took.left_out);
      }
    }
  }
  for (const auto& [column, values] : own) {
    measured[column].insert(measured[column].end(), values.begin(), values.end());
    state.counters[column] = median(values);
  }
}

void print_targets() {
  std::printf("\nmedian over all contours             wanted   measured\n");
  std::printf("ns a point                         <= 25    %8.1f\n", median(measured["ns_point"]));
  std::printf("distances a point                  <= 3     %8.2f\n", median(measured["evaluations"]));
  std::printf("times as fast as the paper's way   >= 30    %8.0f\n", median(measured["papers_way"]));
  std::printf("times as fast with 2 threads       >= 1.8   %8.2f\n", median(measured["two_threads"]));
  std::printf("us a triangle of a mesh            <= 2     %8.2f\n", median(measured["mesh_us_triangle"]));
  std::printf("\n%zu contours have points, %zu of them a mesh\n", measured["points"].size(),
              measured["mesh_us_triangle"].size());
  for (const std::string& contour : left_out) std::printf("no mesh: %s\n", contour.c_str());
}

/// A contour of about so many points to a file: what memory it takes beside the field.
int peak(double points, const std::filesystem::path& folder) {
  const std::vector<Model> found = public_models("head_res222");
  if (found.empty()) return std::fprintf(stderr, "bench: the cylinder head is not there\n"), 1;
  const Mesh mesh = load_model(found.front()).value();
  const Field field = Field::build(mesh.view()).value();
  const double distance = 0.01 * longest_side(field.bounds());
  double tolerance = longest_side(field.bounds()) / 256;
  Counter counter;
  const auto few = static_cast<double>(contour_points(field, distance, {tolerance}, counter)->points);
  // Points go with the square of the fineness, in steps of four.
  for (double expected = few; expected < points; expected *= 4) tolerance /= 2;
  const std::filesystem::path path = folder / "bench_contours.ply";
  const double before = anonymous_memory();
  std::uint64_t written = 0;
  const Measured run = in_process([&] {
    const auto file = create_point_file(path).value();
    const Result<ContourReport> report = contour_points(field, distance, {tolerance}, *file);
    const bool done = report && file->finish();
    std::printf("%.3g points", report ? static_cast<double>(report->points) : 0.0);
    std::fflush(stdout);
    return done;
  });
  std::error_code ignored;
  written = std::filesystem::file_size(path, ignored);
  std::filesystem::remove(path, ignored);
  std::printf(" in %.0f s, %.2f GB; %.0f MiB above the field's %.0f MiB%s\n", run.seconds,
              static_cast<double>(written) / 1e9, run.peak - before, before, run.done ? "" : "; FAILED");
  return run.done ? 0 : 1;
}

}  // namespace
}  // namespace cdfr::bench

int main(int count, char** arguments) {
  using namespace cdfr::bench;
  const std::string json = take_value(count, arguments, "--json");
  const std::string filter = take_value(count, arguments, "--models");
  const std::string fineness = take_value(count, arguments, "--fineness");
  const std::string mesh_limit = take_value(count, arguments, "--mesh-limit");
  const std::string rounds = take_value(count, arguments, "--rounds");
  const std::string points = take_value(count, arguments, "--peak");
  const std::string folder = take_value(count, arguments, "--folder");
  if (!points.empty()) return peak(std::atof(points.c_str()), folder.empty() ? "." : folder);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  Options asked;
  if (!fineness.empty()) asked.fineness = std::atof(fineness.c_str());
  if (!mesh_limit.empty()) asked.mesh_limit = std::atof(mesh_limit.c_str());
  if (!rounds.empty()) asked.rounds = std::max(1, std::atoi(rounds.c_str()));
  for (const Model& model : public_models(filter)) {
    benchmark::RegisterBenchmark(("contours/" + model.name).c_str(), [=](benchmark::State& state) {
      contours(state, model, asked);
    })->Iterations(1);
  }
  TableReporter table({"points", "ns_point", "evaluations", "two_threads", "papers_way", "mesh_us_triangle"});
  const int status = table.run_and_report(json);
  print_targets();
  return status;
}
