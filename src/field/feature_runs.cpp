#include "field/feature_runs.h"

#include <algorithm>

#include "field/query.h"

namespace cdfr {
namespace {

/// Fewer points than this leave a vector so empty that pairs of all kinds together fill it better.
constexpr std::size_t fewest_in_run = 3;

}  // namespace

/// Counts, then places: afterwards ends_[f] is where feature f ends in the order.
void FeatureRuns::sort() noexcept {
  std::uint16_t last = 0;
  for (std::size_t i = 0; i < count_; ++i) last = std::max(last, waiting_[i].feature);
  std::fill_n(ends_.begin(), last + 2, std::uint16_t{0});
  for (std::size_t i = 0; i < count_; ++i) ++ends_[waiting_[i].feature + 1];
  for (std::size_t f = 0; f <= last; ++f) ends_[f + 1] = static_cast<std::uint16_t>(ends_[f + 1] + ends_[f]);
  for (std::size_t i = 0; i < count_; ++i) {
    order_[ends_[waiting_[i].feature]++] = static_cast<std::uint16_t>(i);
  }
}

void FeatureRuns::settle() noexcept {
  if (count_ == 0) return;
  sort();
  for (std::size_t first = 0; first < count_;) {
    const std::size_t end = ends_[waiting_[order_[first]].feature];
    const std::size_t size = std::min(end - first, lane_count);
    run({order_.data() + first, size});
    first += size;
  }
  count_ = 0;
}

void FeatureRuns::run(Members members) noexcept {
  const Waiting& first = waiting_[members[0]];
  const TriangleShape& shape = field_.triangles.shape(first.slot);
  // A triangle of no area has rules of its own (Race).
  if (members.size() < fewest_in_run || rounded(shape.normal) == Vec3{}) {
    for (const std::uint16_t i : members)
      few_.add(waiting_[i].place, waiting_[i].p, side_, {&waiting_[i].slot, 1});
    return;
  }
  PointLanes points;
  for (std::size_t lane = 0; lane < members.size(); ++lane) points.set(lane, waiting_[members[lane]].p);
  for (std::size_t lane = members.size(); lane < lane_count; ++lane) points.set(lane, first.p);
  measure_at(shape, static_cast<TrianglePlace>(first.feature % 8), points, measured_);
  for (std::size_t lane = 0; lane < members.size(); ++lane) {
    out_[waiting_[members[lane]].place] = distance_of(lane, points.p(lane), first.slot, shape);
  }
}

double FeatureRuns::distance_of(std::size_t lane, const Vec3& p, std::uint32_t slot,
                                const TriangleShape& shape) const noexcept {
  if (const auto told = signed_by_leaf(field_, side_, measured_.distance[lane])) return *told;
  Finding finding;
  finding.leaf = side_;
  finding.winner = {measured_.foot(shape, lane), slot, field_.triangles.records[slot].number};
  return signed_distance(field_, {p, 1}, finding);
}

}  // namespace cdfr
