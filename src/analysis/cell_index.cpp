#include "analysis/cell_index.h"

#include <algorithm>
#include <array>
#include <bit>

namespace cdfr {
namespace {

/// The bits of a place that belong to x.
constexpr std::uint64_t bits_of_x = 0x1249249249249249;
/// Half the edge of the deepest cells, in edges of the lattice.
constexpr double deepest_half = 1.0 / (std::uint64_t{2} << deepest_level);
/// Cells a bucket, about.
constexpr std::size_t bucket_size = 4;

/// Every third bit, together.
double gathered(std::uint64_t bits) noexcept {
  bits &= bits_of_x;
  bits = (bits | bits >> 2) & 0x10c30c30c30c30c3;
  bits = (bits | bits >> 4) & 0x100f00f00f00f00f;
  bits = (bits | bits >> 8) & 0x001f0000ff0000ff;
  bits = (bits | bits >> 16) & 0x001f00000000ffff;
  bits = (bits | bits >> 32) & 0x1fffff;
  return static_cast<double>(bits);
}

double& component(Vec3& v, int axis) noexcept { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Most of the possible part's plane over a square across that axis.
bool may_be_deep(const HeavyCell& cell, const Vec3& middle, double half, int axis) noexcept {
  double most = cell.at(middle) + double{cell.above};
  for (int other = 0; other < 3; ++other) {
    if (other != axis) most += half * std::fabs(double{cell.gradient[other]});
  }
  return most > 0;
}

}  // namespace

double half_of(const HeavyCell& cell) noexcept {
  return static_cast<double>(std::uint64_t{1} << (deepest_level - Span::of(cell.key).level)) * deepest_half;
}

Vec3 centre_of(const HeavyCell& cell) noexcept {
  const std::uint64_t first = Span::of(cell.key).first;
  const double half = half_of(cell), place = 2 * deepest_half;
  return {gathered(first) * place + half, gathered(first >> 1) * place + half,
          gathered(first >> 2) * place + half};
}

bool has_core(const CoreRule& rule, const HeavyCell& cell) noexcept {
  return rule.core_point(cell, half_of(cell)).over > 0;
}

bool cores_join(const CoreRule& rule, const HeavyCell& a, const HeavyCell& b) noexcept {
  const CorePoint from = rule.core_point(a, half_of(a)), to = rule.core_point(b, half_of(b));
  if (!(from.over > 0) || !(to.over > 0)) return false;
  const Vec3 c = centre_of(a), d = centre_of(b);
  const double x = d.x + to.y.x - c.x - from.y.x, y = d.y + to.y.y - c.y - from.y.y,
               z = d.z + to.y.z - c.z - from.y.z;
  return rule.joins(from.over, to.over, x * x + y * y + z * z);
}

Touch touch_of(const CoreRule& rule, const HeavyCell& small, const HeavyCell& large) noexcept {
  if (cores_join(rule, small, large)) return Touch::certain;
  const Vec3 a = centre_of(small), b = centre_of(large);
  const double half = half_of(small), apart = half + half_of(large);
  Vec3 away{b.x - a.x, b.y - a.y, b.z - a.z};
  const int axis = std::fabs(away.x) == apart ? 0 : std::fabs(away.y) == apart ? 1 : 2;
  Vec3 from_a{}, from_b{-away.x, -away.y, -away.z};
  const double step = component(away, axis) > 0 ? half : -half;
  component(from_a, axis) += step;
  component(from_b, axis) += step;
  const bool both = may_be_deep(small, from_a, half, axis) && may_be_deep(large, from_b, half, axis);
  return both ? Touch::possible : Touch::none;
}

CellIndex::CellIndex(std::span<const HeavyCell> cells) : cells_(cells) {
  if (cells.empty()) return;
  first_ = Span::of(cells.front().key).first;
  const Span last = Span::of(cells.back().key);
  const std::uint64_t length = last.first + last.size() - first_;
  while ((length >> shift_) > std::max<std::size_t>(1, cells.size() / bucket_size)) ++shift_;
  bucket_.assign((length >> shift_) + 2, static_cast<std::uint32_t>(cells.size()));
  for (std::size_t i = cells.size(); i-- > 0;)
    bucket_[(Span::of(cells[i].key).first - first_) >> shift_] = static_cast<std::uint32_t>(i);
  for (std::size_t b = bucket_.size() - 1; b-- > 0;) bucket_[b] = std::min(bucket_[b], bucket_[b + 1]);
}

/// One more than the last cell that begins at the place or before it.
std::size_t CellIndex::end_at(std::uint64_t place) const noexcept {
  if (cells_.empty() || place < first_) return 0;
  const std::uint64_t bucket = std::min<std::uint64_t>((place - first_) >> shift_, bucket_.size() - 2);
  const auto begin = cells_.begin() + bucket_[bucket], end = cells_.begin() + bucket_[bucket + 1];
  const auto after = std::upper_bound(
      begin, end, place, [](std::uint64_t p, const HeavyCell& cell) { return p < Span::of(cell.key).first; });
  return static_cast<std::size_t>(after - cells_.begin());
}

std::size_t CellIndex::at(std::uint64_t place) const noexcept {
  const std::size_t end = end_at(place);
  if (end == 0) return none;
  const Span span = Span::of(cells_[end - 1].key);
  return place - span.first < span.size() ? end - 1 : none;
}

bool CellIndex::is_any_in(const Span& cube) const noexcept {
  const std::size_t end = end_at(cube.first + cube.size() - 1);
  return end > 0 && Span::of(cells_[end - 1].key).first >= cube.first;
}

bool CellIndex::beside(const Span& own, int axis, bool up, std::uint64_t& place) noexcept {
  const std::uint64_t mask = bits_of_x << axis;
  const std::uint64_t unit = std::uint64_t{1} << (3 * (deepest_level - own.level) + axis);
  const std::uint64_t along = own.first & mask;
  const std::uint64_t moved = up ? ((along | ~mask) + unit) & mask : (along - unit) & mask;
  place = (own.first & ~mask) | moved;
  return up ? moved > along : moved < along;
}

}  // namespace cdfr
