#include "cdfr/field/plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "core/floating_environment.h"
#include "core/parallel.h"
#include "field/build_field.h"
#include "field/domain.h"
#include "field/finished_block.h"
#include "field/stats.h"

namespace cdfr {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One block in so many is built, those of like lists taken together.
constexpr std::size_t sampled = 5;
/// Small meshes have few blocks, no two alike: all are built.
constexpr std::uint64_t small_mesh = 20000;

/// Of a block's leaves and entries, what the sample's come to.
struct Sample {
  double listed = 0, listed_in_all = 0;
  double leaves = 0, nodes = 0, entries = 0;

  double scaled(double amount) const noexcept { return listed > 0 ? amount * listed_in_all / listed : 0; }
};

/// The middle one of every five, in the order of their lists' lengths.
std::vector<std::size_t> chosen(const FieldData& field, const BlockCut& cut) {
  std::vector<std::size_t> order(cut.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cut.listed(a) < cut.listed(b); });
  if (field.triangles.size() <= small_mesh) return order;
  std::vector<std::size_t> some;
  for (std::size_t i = std::min(sampled / 2, order.size() - 1); i < order.size(); i += sampled)
    some.push_back(order[i]);
  return some;
}

Sample take_sample(const FieldData& field, BlockCut& cut, Progress& progress) {
  Sample sample;
  for (std::size_t i = 0; i < cut.size(); ++i) sample.listed_in_all += static_cast<double>(cut.listed(i));
  const std::vector<std::size_t> some = chosen(field, cut);
  std::vector<Sample> parts(some.size());
  progress.phase(0.4, 1, static_cast<double>(some.size()));
  for_chunks(some.size(), 1, [&](std::size_t i, std::size_t) {
    if (progress.cancelled()) return;
    parts[i].listed = static_cast<double>(cut.listed(some[i]));
    const FinishedBlock finished = finished_block(field, cut, some[i], progress);
    parts[i].leaves = static_cast<double>(finished.block.leaves.size());
    parts[i].nodes = static_cast<double>(finished.block.nodes.size());
    parts[i].entries = static_cast<double>(finished.block.entries.size());
    progress.step();
  });
  for (const Sample& part : parts) {
    sample.listed += part.listed;
    sample.leaves += part.leaves;
    sample.nodes += part.nodes;
    sample.entries += part.entries;
  }
  return sample;
}

std::uint64_t rounded(double x) noexcept { return static_cast<std::uint64_t>(std::llround(x)); }

FieldPlan planned(const FieldData& field, const Sample& sample, double prepared_s, double sample_s) {
  FieldPlan plan;
  plan.triangles = field.triangles.size();
  const double leaves = sample.scaled(sample.leaves), entries = sample.scaled(sample.entries);
  plan.leaves = rounded(leaves);
  plan.entries = rounded(entries);
  // Nodes lie in blocks and in the index, which has a cell of its grid for each leaf or fewer.
  const double tree = entries * sizeof(Entry) + leaves * (sizeof(LeafRecord) + sizeof(LeafIndex::Leaf)) +
                      sample.scaled(sample.nodes) * 2 * sizeof(TreeNode);
  const auto mesh = static_cast<double>(total_bytes(field));
  plan.bytes = rounded(mesh + tree);
  // Topology, twins and sums of normals, while both they and what they become are there: 450 bytes a
  // triangle, or the octree twice while its blocks are joined.
  plan.peak_bytes = rounded(std::max(450.0 * static_cast<double>(plan.triangles), mesh + 2 * tree));
  plan.seconds = prepared_s + sample.scaled(sample_s);
  return plan;
}

}  // namespace

Result<FieldPlan> plan_field(MeshView mesh, const BuildOptions& options, const Run& run) {
  if (std::optional<Error> error = refused(options)) return *error;
  const FloatingEnvironment environment;
  Progress progress(run);
  Result<FieldPlan> plan = Progress::error();
  with_threads(run, [&] {
    auto start = Clock::now();
    Result<FieldData> field = prepare_field(mesh, options, progress);
    if (!field) {
      plan = field.error();
      return;
    }
    lay_lattice(*field);
    BlockCut cut(field->space(), field->tree.lattice, field->options, progress, cells_left_out(*field));
    const double prepared_s = seconds_since(start);
    start = Clock::now();
    if (progress.cancelled()) return;
    const Sample sample = take_sample(*field, cut, progress);
    if (!progress.cancelled()) plan = planned(*field, sample, prepared_s, seconds_since(start));
  });
  return plan;
}

}  // namespace cdfr
