/// What the lists of a leaf and the depth of the tree cost and give: memory and build against the time of a
/// query, and from how many queries on each choice pays.
///   bench_sweep [--json FILE] [--models PART_OF_NAME] [--quick] [options of Google Benchmark]
#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arguments.h"
#include "course.h"
#include "models.h"
#include "rounds.h"
#include "settings.h"
#include "sweep_report.h"

namespace cdfr::bench {
namespace {

using benchmark::State;

/// The course of the model that is being measured, and what each setting built over it.
struct Current {
  std::string path;
  std::unique_ptr<Course> course;
  std::map<std::string, std::unique_ptr<System>> systems;  ///< by the setting's name
};

Current& current() {
  static Current one;
  return one;
}

const Course* course_of(const Model& model, const Effort& effort) {
  if (current().path != model.path) {
    current() = {model.path, nullptr, {}};
    Result<Course> made = make_course(model, effort);
    if (made) current().course = std::make_unique<Course>(std::move(*made));
  }
  return current().course.get();
}

void build(State& state, const Setting& setting, const Course& course) {
  for (auto _ : state) {
    auto built = setting.build(course.mesh);
    if (built) {
      current().systems[setting.name] = std::move(*built);
    } else {
      state.SkipWithError(built.error().text.c_str());
    }
  }
  state.counters["items"] = 1;
}

void facts(State& state, const Setting& setting, const Course& course) {
  const System& system = *current().systems.at(setting.name);
  for (auto _ : state) state.counters["bytes"] = static_cast<double>(system.bytes());
  state.counters["triangles"] = static_cast<double>(course.mesh.triangles.size());
}

void singles(State& state, const Setting& setting, const std::vector<Vec3>& points) {
  const System& system = *current().systems.at(setting.name);
  std::vector<double> out(points.size());
  const std::span<const Vec3> some(points.data(), points.size() / 10);
  system.singles(some, out);
  for (auto _ : state) system.singles(points, out);
  state.counters["items"] = static_cast<double>(points.size());
}

template <class Measure>
void add(const std::string& what, const Setting& setting, const Model& model, const Effort& effort,
         Measure measure) {
  const auto run = [setting, model, effort, measure](State& state) {
    const Course* course = course_of(model, effort);
    if (course == nullptr) return state.SkipWithError("the model cannot be read");
    measure(state, setting, *course);
  };
  benchmark::RegisterBenchmark((what + "/" + setting.name + "/" + model.name).c_str(), run)
      ->Iterations(1)
      ->Unit(benchmark::kNanosecond)
      ->UseRealTime();
}

/// Everything is built first; then the settings take turns, so that a slow minute of the machine meets them
/// all.
void add_model(const Model& model, const std::vector<Setting>& settings, const Effort& effort) {
  for (const Setting& setting : settings) {
    add("build", setting, model, effort, build);
    add("facts", setting, model, effort, facts);
  }
  const auto random = [](State& state, const Setting& s, const Course& c) { singles(state, s, c.random); };
  const auto near = [](State& state, const Setting& s, const Course& c) { singles(state, s, c.near); };
  for (int round = 0; round < effort.rounds; ++round) {
    for (const Setting& setting : settings) {
      add("random", setting, model, effort, random);
      add("near", setting, model, effort, near);
    }
  }
}

int run(int count, char** arguments) {
  const std::string json = take_value(count, arguments, "--json");
  const std::string filter = take_value(count, arguments, "--models");
  const bool quick = take_flag(count, arguments, "--quick");
  const Effort effort = quick ? quick_effort() : Effort{};
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  const std::vector<Setting> all = settings(quick);
  const std::vector<Model> models = public_models(filter);
  for (const Model& model : models) add_model(model, all, effort);
  RoundsReporter reporter;
  if (models.empty() || benchmark::RunSpecifiedBenchmarks(&reporter) == 0) {
    std::fprintf(stderr, "bench: no such model\n");
    return 1;
  }
  print_sweep(reporter.sheets(), all);
  if (!json.empty() && !write_sweep(reporter.sheets(), all, json)) {
    std::fprintf(stderr, "bench: cannot write %s\n", json.c_str());
    return 1;
  }
  return reporter.failed() ? 1 : 0;
}

}  // namespace
}  // namespace cdfr::bench

int main(int count, char** arguments) { return cdfr::bench::run(count, arguments); }
