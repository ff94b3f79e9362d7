/// How long the lists of leaves are: against the source paper's rule, and against a lower bound of what any
/// rule must keep.
///   bench_lists [--json FILE] [--models PART_OF_NAME] [options of Google Benchmark]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "arguments.h"
#include "cdfr/field/field.h"
#include "models.h"
#include "random.h"
#include "table.h"
#include "winners.h"

namespace cdfr::bench {
namespace {

using benchmark::State;

constexpr std::size_t most_leaves = 400;

void count_lists(State& state, const std::string& rule, const Stats& stats) {
  state.counters[rule + "_leaves"] = static_cast<double>(stats.inside_leaves + stats.surface_leaves +
                                                         stats.outside_leaves + stats.undecided_leaves);
  state.counters[rule + "_mean"] = stats.mean_list;
  state.counters[rule + "_p95"] = stats.p95_list;
  state.counters[rule + "_max"] = static_cast<double>(stats.max_list);
}

/// Lists and winners of the same leaves, evenly drawn.
void count_winners(State& state, const Field& field) {
  const std::size_t leaves = std::min(field.leaf_count(), most_leaves);
  Random random;
  double listed = 0, won = 0;
  for (std::size_t i = 0; i < leaves; ++i) {
    const auto number = static_cast<std::size_t>(random.unit() * static_cast<double>(field.leaf_count()));
    const Leaf leaf = field.leaf(number);
    listed += static_cast<double>(leaf.triangles.size());
    won += static_cast<double>(winners(field, leaf.box));
  }
  state.counters["drawn_mean"] = listed / static_cast<double>(leaves);
  state.counters["winners_mean"] = won / static_cast<double>(leaves);
  state.counters["list/winners"] = listed / won;
}

void lists(State& state, const Model& model) {
  const Result<Mesh> mesh = load_model(model);
  if (!mesh) return state.SkipWithError(mesh.error().text.c_str());
  for (auto _ : state) {
    state.counters["triangles"] = static_cast<double>(mesh->triangles.size());
    const Result<Field> field = Field::build(mesh->view());
    const Result<Field> band = Field::build(mesh->view(), {.lists = Lists::band});
    if (!field || !band) return state.SkipWithError("the model cannot be built");
    count_lists(state, "corner", field->stats());
    count_lists(state, "band", band->stats());
    count_winners(state, *field);
  }
}

int run(int count, char** arguments) {
  const std::string json = take_value(count, arguments, "--json");
  const std::string filter = take_value(count, arguments, "--models");
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  for (const Model& model : public_models(filter)) {
    benchmark::RegisterBenchmark(("lists/" + model.name).c_str(), [model](State& state) {
      lists(state, model);
    })->Iterations(1);
  }
  TableReporter table({"triangles", "corner_leaves", "corner_mean", "corner_p95", "corner_max", "band_leaves",
                       "band_mean", "band_p95", "band_max", "drawn_mean", "winners_mean", "list/winners"});
  return table.run_and_report(json);
}

}  // namespace
}  // namespace cdfr::bench

int main(int count, char** arguments) { return cdfr::bench::run(count, arguments); }
