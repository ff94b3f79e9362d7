#include "cdfr/field/field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "field/batch.h"
#include "field/batch_order.h"
#include "field/build_field.h"
#include "field/cut_field.h"
#include "field/deepest.h"
#include "field/domain.h"
#include "field/field_data.h"
#include "field/grid_query.h"
#include "field/leaves.h"
#include "field/query.h"
#include "field/stats.h"
#include "geometry/box_distance.h"

namespace cdfr {
namespace {

/// Points a task answers.
constexpr std::size_t batch_chunk = 2048;
/// Fewer points are not worth an order; more are taken in rounds of so many, whose order takes 50 MB.
constexpr std::size_t least_ordered = std::size_t{1} << 14, most_ordered = std::size_t{1} << 22;

Leaf leaf_at(const FieldData& field, const Block& block, const Cell& cell, std::uint32_t number) {
  Leaf leaf;
  leaf.key = key_of(cell);
  leaf.level = cell.level;
  leaf.box = field.tree.lattice.box(cell);
  leaf.side = block.leaves[number].side();
  for (const std::uint32_t slot : slots_of(field, block, block.leaves[number])) {
    leaf.triangles.push_back(field.triangles.records[slot].number);
  }
  std::sort(leaf.triangles.begin(), leaf.triangles.end());
  return leaf;
}

/// x[first] .. x[first + count - 1], in the order in which they are answered best.
template <class Answer>
void answer_ordered(const FieldData& field, Points x, std::size_t first, std::size_t count,
                    std::span<Answer> out, Progress& progress) {
  const std::vector<std::uint32_t> order = along_curve(field, x, first, count);
  for_chunks(count, batch_chunk, [&](std::size_t begin, std::size_t end) {
    if (progress.cancelled()) return;
    std::vector<Vec3> points;
    points.reserve(end - begin);
    std::vector<Answer> answers(end - begin);
    for (std::size_t i = begin; i < end; ++i) points.push_back(x[first + order[i]]);
    if (!answer(field, Points(points), 0, std::span<Answer>(answers), progress)) return;
    for (std::size_t i = begin; i < end; ++i) out[first + order[i]] = answers[i - begin];
    progress.step();
  });
}

template <class Answer>
Result<void> answer_all(const FieldData& field, Points x, std::span<Answer> out, const Run& run) {
  assert(out.size() == x.size());
  Progress progress(run);
  progress.phase(0, 1, static_cast<double>((x.size() + batch_chunk - 1) / batch_chunk));
  with_threads(run, [&] {
    if (x.size() >= least_ordered) {
      for (std::size_t first = 0; first < x.size(); first += most_ordered)
        answer_ordered(field, x, first, std::min(most_ordered, x.size() - first), out, progress);
      return;
    }
    for_chunks(x.size(), batch_chunk, [&](std::size_t first, std::size_t end) {
      if (progress.cancelled()) return;
      if (answer(field, x, first, out.subspan(first, end - first), progress)) progress.step();
    });
  });
  if (progress.cancelled()) return Progress::error();
  return field.status();
}

Closest nowhere() noexcept {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Closest result;
  result.distance = nan;
  result.point = result.gradient = {nan, nan, nan};
  result.barycentric = {nan, nan, nan};
  return result;
}

}  // namespace

Result<Field> Field::build(MeshView mesh, const BuildOptions& options, const Run& run) {
  Result<FieldData> data = build_field(mesh, options, run);
  if (!data) return data.error();
  return Field(std::make_shared<const FieldData>(std::move(data).value()));
}

double Field::distance(Vec3 x) const noexcept {
  const double distance = signed_distance(*data_, x);
  return data_->failed() ? std::numeric_limits<double>::quiet_NaN() : distance;
}

Closest Field::closest(Vec3 x) const noexcept {
  const Closest closest = closest_point(*data_, x, Finder::tree);
  return data_->failed() ? nowhere() : closest;
}

Result<void> Field::status() const { return data_->status(); }

Result<void> Field::distance(Points x, std::span<double> out, const Run& run) const {
  return answer_all(*data_, x, out, run);
}

Result<void> Field::distance(const Grid& grid, std::span<double> out, const Run& run) const {
  assert(out.size() == grid.count());
  if (Result<void> done = grid_distances(*data_, grid, out, run); !done) return done;
  return status();
}

Result<void> Field::closest(Points x, std::span<Closest> out, const Run& run) const {
  return answer_all(*data_, x, out, run);
}

Result<Field> Field::at_level(int level) const {
  if (level < 0 || level > deepest_level) return Error{Code::bad_option, 0, "level must be 0 to 18"};
  const FloatingEnvironment environment;
  FieldData cut = cut_field(*data_, level);
  if (data_->failed()) return data_->status().error();
  return Field(std::make_shared<const FieldData>(std::move(cut)));
}

Result<Deepest> Field::deepest(double error, const Run& run) const {
  if (!(error >= 0 && std::isfinite(error)))
    return Error{Code::bad_option, 0, "error must be 0 or more and finite"};
  if (data_->sign == Sign::none)
    return Error{Code::not_closed, 0, "an unsigned field has no inside: no deepest point"};
  const FloatingEnvironment environment;
  Progress progress(run);
  progress.watch(data_->map.get());
  Result<Deepest> deepest = Progress::error();
  with_threads(run, [&] {
    deepest = deepest_point(*data_, error > 0 ? error : longest_side(bounds()) / 1000, progress);
  });
  return deepest;
}

Box Field::domain() const noexcept { return data_->tree.lattice.domain(); }
Box Field::bounds() const noexcept { return data_->bounds(); }
Sign Field::sign() const noexcept { return data_->sign; }
const MeshReport& Field::report() const noexcept { return data_->report; }
BuildOptions Field::options() const noexcept { return data_->options; }
Stats Field::stats() const { return stats_of(*data_); }
std::uint64_t Field::checksum() const { return checksum_of(*data_); }
std::size_t Field::leaf_count() const noexcept { return data_->tree.leaves.size(); }

Leaf Field::leaf(std::size_t i) const {
  assert(i < leaf_count());
  const std::size_t block_number = data_->tree.block_of_leaf(i);
  const Block block = data_->tree.block(block_number);
  const std::uint64_t first = data_->tree.starts[block_number].leaf;
  Leaf leaf;
  cdfr::for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
    if (first + number == i) leaf = leaf_at(*data_, block, cell, number);
  });
  return leaf;
}

void Field::for_each_leaf(const std::function<void(const Leaf&)>& visit) const {
  for (std::size_t i = 0; i < data_->tree.block_count(); ++i) {
    const Block block = data_->tree.block(i);
    cdfr::for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
      if (!is_left_out(*data_, block, block.leaves[number])) visit(leaf_at(*data_, block, cell, number));
    });
  }
}

}  // namespace cdfr
