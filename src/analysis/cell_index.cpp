#include "analysis/cell_index.h"

#include <algorithm>
#include <array>
#include <bit>

namespace cdfr {
namespace {

/// The bits of a place that belong to x.
constexpr std::uint64_t bits_of_x = 0x1249249249249249;
/// Cells a bucket, about.
constexpr std::size_t bucket_size = 4;

Vec3 centre_of(const HeavyCell& cell) noexcept {
  const Cell at = cell_of(cell.key);
  const double size = std::ldexp(1.0, -at.level);
  return {(at.place[0] + 0.5) * size, (at.place[1] + 0.5) * size, (at.place[2] + 0.5) * size};
}

double half_of(const HeavyCell& cell) noexcept { return Span::of(cell.key).half(); }

double& component(Vec3& v, int axis) noexcept { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Most of the possible part's plane over a square across that axis.
bool may_be_deep(const HeavyCell& cell, const Vec3& middle, double half, int axis) noexcept {
  double most = cell.at(middle) + double{cell.above};
  for (int other = 0; other < 3; ++other) {
    if (other != axis) most += half * std::fabs(double{cell.gradient[other]});
  }
  return most > 0;
}

bool is_sure(const HeavyCell& cell, const Vec3& y) noexcept { return cell.at(y) - double{cell.below} > 0; }

}  // namespace

Touch touch_of(const HeavyCell& small, const HeavyCell& large) noexcept {
  const Vec3 a = centre_of(small), b = centre_of(large);
  const double half = half_of(small), apart = half + half_of(large);
  Vec3 away{b.x - a.x, b.y - a.y, b.z - a.z};
  const int axis = std::fabs(away.x) == apart ? 0 : std::fabs(away.y) == apart ? 1 : 2;
  Vec3 from_a{}, from_b{-away.x, -away.y, -away.z};
  const double step = component(away, axis) > 0 ? half : -half;
  component(from_a, axis) += step;
  component(from_b, axis) += step;
  if (!may_be_deep(small, from_a, half, axis) || !may_be_deep(large, from_b, half, axis)) return Touch::none;
  // Where the first one's sure part reaches into the face farthest, and the second one's, and in the middle.
  for (const HeavyCell* steep : {&small, &large, static_cast<const HeavyCell*>(nullptr)}) {
    Vec3 y = from_a, z = from_b;
    for (int other = 0; other < 3 && steep != nullptr; ++other) {
      if (other == axis) continue;
      const double move = std::copysign(half, double{steep->gradient[other]});
      component(y, other) += move;
      component(z, other) += move;
    }
    if (is_sure(small, y) && is_sure(large, z)) return Touch::certain;
  }
  return Touch::possible;
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
  std::size_t end = bucket_[bucket + 1];
  while (end > bucket_[bucket] && Span::of(cells_[end - 1].key).first > place) --end;
  return end;
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
