/// What the engine costs: building, asking and extracting, model by model.
///   bench_engine [--json FILE] [options of Google Benchmark]
#include <benchmark/benchmark.h>

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arguments.h"
#include "cdfr/contour/contour.h"
#include "models.h"
#include "subject.h"
#include "table.h"

namespace cdfr::bench {
namespace {

using benchmark::State;
using Counter = benchmark::Counter;

/// The field of the model that is being measured; one at a time, since a large one fills gigabytes.
const Subject* subject_of(const Model& model) {
  static std::string name;
  static std::unique_ptr<Subject> subject;
  if (name != model.name) {
    subject.reset();
    name = model.name;
    Result<Mesh> mesh = load_model(model);
    if (!mesh) return nullptr;
    Result<Subject> made = make_subject(std::move(*mesh));
    if (made) subject = std::make_unique<Subject>(std::move(*made));
  }
  return subject.get();
}

Counter nanoseconds_each(double items_an_iteration) {
  return Counter(items_an_iteration * 1e-9, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void count_lists(State& state, const Stats& stats) {
  const auto leaves = static_cast<double>(stats.inside_leaves + stats.surface_leaves + stats.outside_leaves);
  const auto triangles = static_cast<double>(stats.triangles);
  state.counters["triangles"] = triangles;
  state.counters["leaves"] = leaves;
  state.counters["entries_leaf"] = static_cast<double>(stats.entries) / leaves;
  state.counters["list_mean"] = stats.mean_list;
  state.counters["list_p95"] = stats.p95_list;
  state.counters["list_max"] = static_cast<double>(stats.max_list);
  state.counters["bytes_triangle"] = static_cast<double>(stats.bytes) / triangles;
}

void build(State& state, const Subject& subject) {
  const BuildOptions options;
  for (auto _ : state) {
    benchmark::DoNotOptimize(Field::build(subject.mesh.view(), options, {.threads = 1}));
  }
  const Counter::Flags each = Counter::kIsIterationInvariantRate | Counter::kInvert;
  state.counters["build_s"] = Counter(1, each);
  state.counters["build_us_triangle"] =
      Counter(static_cast<double>(subject.mesh.triangles.size()) * 1e-6, each);
  count_lists(state, subject.field.stats());
}

void distance(State& state, const Field& field, const std::vector<Vec3>& points, const char* column) {
  for (auto _ : state) {
    for (const Vec3& point : points) benchmark::DoNotOptimize(field.distance(point));
  }
  state.counters[column] = nanoseconds_each(static_cast<double>(points.size()));
}

void closest(State& state, const Field& field, const std::vector<Vec3>& points, const char* column) {
  for (auto _ : state) {
    for (const Vec3& point : points) benchmark::DoNotOptimize(field.closest(point));
  }
  state.counters[column] = nanoseconds_each(static_cast<double>(points.size()));
}

void batch(State& state, const Subject& subject) {
  std::vector<double> out(subject.anywhere.size());
  for (auto _ : state) {
    const Result<void> done =
        subject.field.distance(std::span<const Vec3>(subject.anywhere), out, {.threads = 1});
    if (!done) state.SkipWithError(done.error().text.c_str());
  }
  state.counters["batch_ns"] = nanoseconds_each(static_cast<double>(out.size()));
}

class NoSink : public PointSink {
 public:
  Result<void> write(std::span<const ContourPoint>) override { return {}; }
};

void contour(State& state, const Subject& subject) {
  const ContourOptions options{.tolerance = subject.longest_side / 512};
  ContourReport report;
  for (auto _ : state) {
    NoSink sink;
    const Result<ContourReport> done =
        contour_points(subject.field, subject.contour_distance, options, sink, {.threads = 1});
    if (!done) return state.SkipWithError(done.error().text.c_str());
    report = *done;
  }
  const auto points = static_cast<double>(report.points);
  state.counters["contour_at"] = subject.contour_distance;
  state.counters["points"] = points;
  state.counters["undecided"] = static_cast<double>(report.undecided);
  state.counters["evaluations"] = static_cast<double>(report.evaluations);
  state.counters["contour_ns_point"] = nanoseconds_each(points);
}

template <class Measure>
void add(const char* name, const Model& model, Measure measure) {
  const auto run = [model, measure](State& state) {
    const Subject* subject = subject_of(model);
    if (subject == nullptr) return state.SkipWithError("the model cannot be read or built");
    measure(state, *subject);
  };
  benchmark::RegisterBenchmark((std::string(name) + "/" + model.name).c_str(), run)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void add_all() {
  for (const Model& model : models()) {
    add("build", model, build);
    add("distance", model,
        [](State& state, const Subject& s) { distance(state, s.field, s.anywhere, "distance_ns"); });
    add("closest", model,
        [](State& state, const Subject& s) { closest(state, s.field, s.anywhere, "closest_ns"); });
    add("near_distance", model,
        [](State& state, const Subject& s) { distance(state, s.field, s.near_surface, "near_distance_ns"); });
    add("near_closest", model,
        [](State& state, const Subject& s) { closest(state, s.field, s.near_surface, "near_closest_ns"); });
    add("batch", model, batch);
    add("contour", model, contour);
  }
}

int run(int count, char** arguments) {
  const std::string json = take_value(count, arguments, "--json");
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  add_all();
  TableReporter table({"triangles", "leaves", "entries_leaf", "list_mean", "list_p95", "list_max",
                       "bytes_triangle", "build_s", "build_us_triangle", "distance_ns", "closest_ns",
                       "near_distance_ns", "near_closest_ns", "batch_ns", "points", "contour_ns_point"});
  return table.run_and_report(json);
}

}  // namespace
}  // namespace cdfr::bench

int main(int count, char** arguments) { return cdfr::bench::run(count, arguments); }
