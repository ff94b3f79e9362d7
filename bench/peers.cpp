/// How cdfr compares with other engines that answer exact distances: over the same meshes and the same
/// points, in one process, in turns.
///   bench_peers [--json FILE] [--models PART_OF_NAME] [--quick] [options of Google Benchmark]
#include <benchmark/benchmark.h>

#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arguments.h"
#include "check.h"
#include "contest.h"
#include "models.h"
#include "peers_report.h"
#include "pointer_chase.h"
#include "rounds.h"
#include "targets.h"

namespace cdfr::bench {
namespace {

using benchmark::State;

/// The contest of the model that is being measured; one at a time, since a large one fills gigabytes.
const Contest* contest_of(const Model& model, const Effort& effort) {
  static std::string path;
  static std::unique_ptr<Contest> contest;
  if (path != model.path) {
    contest.reset();
    path = model.path;
    Result<Contest> made = make_contest(model, effort);
    if (made) {
      contest = std::make_unique<Contest>(std::move(*made));
    } else {
      std::fprintf(stderr, "bench: %s: %s\n", model.name.c_str(), made.error().text.c_str());
    }
  }
  return contest.get();
}

void count_items(State& state, std::size_t items) { state.counters["items"] = static_cast<double>(items); }

/// What the caches held for the system before is not what they hold for this one.
void warm_up(const System& system, const std::vector<Vec3>& points) {
  const std::span<const Vec3> some(points.data(), points.size() / 10);
  std::vector<double> out(some.size());
  system.singles(some, out);
}

void singles(State& state, const System& system, const std::vector<Vec3>& points) {
  std::vector<double> out(points.size());
  warm_up(system, points);
  for (auto _ : state) system.singles(points, out);
  count_items(state, points.size());
}

void batch(State& state, const System& system, const std::vector<Vec3>& points, unsigned threads) {
  std::vector<double> out(points.size());
  warm_up(system, points);
  for (auto _ : state) system.batch(points, out, threads);
  count_items(state, points.size());
}

void grid(State& state, const System& system, const std::vector<SampleGrid>& slabs, unsigned threads) {
  std::size_t points = 0;
  for (const SampleGrid& slab : slabs) points += slab.count();
  std::vector<double> out(points);
  warm_up(system, points_of(slabs.front(), 0, 1));
  for (auto _ : state) {
    std::span<double> left(out);
    for (const SampleGrid& slab : slabs) {
      system.fill(slab, left.first(slab.count()), threads);
      left = left.subspan(slab.count());
    }
  }
  count_items(state, points);
}

void build(State& state, const SystemKind& kind, const Mesh& mesh, unsigned threads) {
  std::unique_ptr<System> built;  // outlives the loop: freeing it is not building it
  for (auto _ : state) built = std::move(kind.build(mesh, threads).value());
  count_items(state, 1);
}

/// From the mesh in memory to the last of so many answers, one by one. cdfr is told how many there will be.
void total(State& state, std::size_t system, const Course& course, std::size_t queries) {
  std::vector<Vec3> points(queries);
  for (std::size_t i = 0; i < queries; ++i) points[i] = course.random[i % course.random.size()];
  std::vector<double> out(queries);
  std::unique_ptr<System> built;
  for (auto _ : state) {
    built = std::move((system == 0 ? build_cdfr(course.mesh, {.expected_queries = queries}, 1)
                                   : system_kinds()[system].build(course.mesh, 1))
                          .value());
    built->singles(points, out);
  }
  count_items(state, 1);
}

/// The only benchmark that states facts instead of taking time.
void facts(State& state, const System& system, const Contest& contest, bool is_cdfr) {
  double error = 0;
  std::size_t different = 0;
  for (auto _ : state) {
    error = worst_error(system, contest);
    if (is_cdfr) different = count_different(system, contest);
  }
  state.counters["triangles"] = static_cast<double>(contest.course.mesh.triangles.size());
  state.counters["bytes"] = static_cast<double>(system.bytes());
  state.counters["checked"] = static_cast<double>(contest.truth.points.size());
  state.counters["worst_error"] = error;
  state.counters["different"] = static_cast<double>(different);
}

void dependent_misses(State& state) {
  static PointerChase chase;
  constexpr std::size_t steps = 1'000'000;
  for (auto _ : state) benchmark::DoNotOptimize(chase.follow(steps));
  count_items(state, steps);
}

template <class Measure>
void add(const std::string& workload, const std::string& system, const Model& model, const Effort& effort,
         Measure measure) {
  const auto run = [model, effort, measure](State& state) {
    const Contest* contest = contest_of(model, effort);
    if (contest == nullptr) return state.SkipWithError("the model cannot be read or built");
    measure(state, *contest);
  };
  benchmark::RegisterBenchmark((workload + "/" + system + "/" + model.name).c_str(), run)
      ->Iterations(1)
      ->Unit(benchmark::kNanosecond)
      ->UseRealTime();
}

/// One workload after another, and in each all systems, so that a slow minute of the machine hits them all.
template <class Measure>
void add_all(const std::string& workload, const Model& model, const Effort& effort, Measure measure) {
  const std::vector<SystemKind> kinds = system_kinds();
  for (std::size_t s = 0; s < kinds.size(); ++s) {
    add(workload, kinds[s].name, model, effort,
        [measure, s](State& state, const Contest& c) { measure(state, c, s); });
  }
}

void add_queries(const Model& model, const Effort& effort) {
  add("miss", "machine", model, effort, [](State& state, const Contest&) { dependent_misses(state); });
  add_all("random", model, effort, [](State& state, const Contest& c, std::size_t s) {
    singles(state, *c.systems[s], c.course.random);
  });
  add_all("near", model, effort, [](State& state, const Contest& c, std::size_t s) {
    singles(state, *c.systems[s], c.course.near);
  });
  add_all("far", model, effort,
          [](State& state, const Contest& c, std::size_t s) { singles(state, *c.systems[s], c.course.far); });
  add_all("batch", model, effort, [](State& state, const Contest& c, std::size_t s) {
    batch(state, *c.systems[s], s == 0 ? c.course.batch : c.course.random, 1);
  });
  add_all("grid", model, effort, [](State& state, const Contest& c, std::size_t s) {
    grid(state, *c.systems[s], s == 0 ? c.course.grid : c.course.grid_peers, 1);
  });
  add("batch2", "cdfr", model, effort,
      [](State& state, const Contest& c) { batch(state, *c.systems[0], c.course.batch, 2); });
  add("grid2", "cdfr", model, effort,
      [](State& state, const Contest& c) { grid(state, *c.systems[0], c.course.grid, 2); });
}

void add_builds(const Model& model, const Effort& effort) {
  add_all("build", model, effort, [](State& state, const Contest& c, std::size_t s) {
    build(state, system_kinds()[s], c.course.mesh, 1);
  });
  for (const std::size_t queries : total_queries) {
    add_all("total" + std::to_string(queries), model, effort,
            [queries](State& state, const Contest& c, std::size_t s) { total(state, s, c.course, queries); });
  }
  add("build2", "cdfr", model, effort,
      [](State& state, const Contest& c) { build(state, system_kinds()[0], c.course.mesh, 2); });
}

void add_model(const Model& model, const Effort& effort) {
  add_all("check", model, effort,
          [](State& state, const Contest& c, std::size_t s) { facts(state, *c.systems[s], c, s == 0); });
  for (int round = 0; round < effort.rounds; ++round) {
    add_queries(model, effort);
    if (round < effort.build_rounds) add_builds(model, effort);
  }
}

/// Says on stderr which answers of cdfr are not brute force's.
bool all_right(const std::vector<Sheet>& sheets) {
  bool right = true;
  for (const Sheet& sheet : sheets) {
    if (!(sheet.fact("cdfr", "different") > 0)) continue;
    right = false;
    std::fprintf(stderr, "bench: %s: %.0f answers of cdfr differ from brute force\n", sheet.model.c_str(),
                 sheet.fact("cdfr", "different"));
  }
  return right;
}

int run(int count, char** arguments) {
  const std::string json = take_value(count, arguments, "--json");
  const std::string filter = take_value(count, arguments, "--models");
  const Effort effort = take_flag(count, arguments, "--quick") ? quick_effort() : Effort{};
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  const std::vector<Model> models = public_models(filter);
  for (const Model& model : models) add_model(model, effort);
  RoundsReporter reporter;
  if (models.empty() || benchmark::RunSpecifiedBenchmarks(&reporter) == 0) {
    std::fprintf(stderr, "bench: no such model\n");
    return 1;
  }
  print_report(reporter.sheets());
  if (!json.empty() && !write_report(reporter.sheets(), json)) {
    std::fprintf(stderr, "bench: cannot write %s\n", json.c_str());
    return 1;
  }
  return all_right(reporter.sheets()) && !reporter.failed() ? 0 : 1;
}

}  // namespace
}  // namespace cdfr::bench

int main(int count, char** arguments) { return cdfr::bench::run(count, arguments); }
