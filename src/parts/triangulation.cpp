#include "parts/triangulation.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <tuple>

#include "cdfr/core/types.h"

namespace cdfr {
namespace {

/// The polygon is on the left of the way from one end to the other; of a diagonal on both sides.
struct Side {
  std::uint32_t from, to;
};

bool apart(std::int64_t s, std::int64_t t) noexcept { return (s < 0 && t > 0) || (s > 0 && t < 0); }

class Greedy {
 public:
  explicit Greedy(std::span<const Outline> loops);
  void add_diagonals();
  std::vector<std::array<std::uint32_t, 3>> triangles() const;

 private:
  bool clear(std::uint32_t a, std::uint32_t b) const noexcept;
  bool inside(std::uint32_t a, std::uint32_t b) const noexcept;
  std::uint32_t apex(Side side, const std::vector<std::vector<std::uint32_t>>& neighbours) const;

  std::vector<PlanPoint> points_;
  std::vector<Side> sides_;  ///< the border's, then the diagonals
  std::size_t border_ = 0, wanted_ = 0;
};

/// Every triangle has three sides; the border's belong to one triangle and the diagonals to two.
Greedy::Greedy(std::span<const Outline> loops) {
  for (const Outline& loop : loops) {
    const bool hole = !points_.empty();
    const auto first = static_cast<std::uint32_t>(points_.size());
    const auto count = static_cast<std::uint32_t>(loop.size());
    points_.insert(points_.end(), loop.begin(), loop.end());
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t here = first + i, next = first + (i + 1) % count;
      sides_.push_back(hole ? Side{next, here} : Side{here, next});
    }
  }
  border_ = sides_.size();
  wanted_ = 2 * points_.size() + 3 * (loops.size() - 2);
}

void Greedy::add_diagonals() {
  std::vector<std::tuple<std::int64_t, std::uint32_t, std::uint32_t>> lines;  // squared length, ends
  for (std::uint32_t a = 0; a < points_.size(); ++a) {
    for (std::uint32_t b = a + 1; b < points_.size(); ++b) {
      const std::int64_t x = points_[b].x - points_[a].x, y = points_[b].y - points_[a].y;
      lines.emplace_back(x * x + y * y, a, b);
    }
  }
  std::sort(lines.begin(), lines.end());
  for (const auto& [length, a, b] : lines) {
    if (sides_.size() == wanted_) return;
    if (clear(a, b) && inside(a, b)) sides_.push_back({a, b});
  }
  assert(sides_.size() == wanted_);
}

/// Whether the line from a to b is no side, crosses none and passes over no corner.
bool Greedy::clear(std::uint32_t a, std::uint32_t b) const noexcept {
  const PlanPoint p = points_[a], q = points_[b];
  for (const auto& [c, d] : sides_) {
    if ((a == c && b == d) || (a == d && b == c)) return false;
    const PlanPoint r = points_[c], s = points_[d];
    if (apart(turn(p, q, r), turn(p, q, s)) && apart(turn(r, s, p), turn(r, s, q))) return false;
  }
  return std::none_of(points_.begin(), points_.end(), [&](PlanPoint r) {
    const std::int64_t along = (r.x - p.x) * (r.x - q.x) + (r.y - p.y) * (r.y - q.y);
    return along < 0 && turn(p, q, r) == 0;
  });
}

/// Whether the middle of a clear line is in the polygon: a ray to the right crosses the border an odd number
/// of times. In halves of the plan's units.
bool Greedy::inside(std::uint32_t a, std::uint32_t b) const noexcept {
  const PlanPoint middle{points_[a].x + points_[b].x, points_[a].y + points_[b].y};
  bool odd = false;
  for (std::size_t i = 0; i < border_; ++i) {
    const PlanPoint from{2 * points_[sides_[i].from].x, 2 * points_[sides_[i].from].y};
    const PlanPoint to{2 * points_[sides_[i].to].x, 2 * points_[sides_[i].to].y};
    if ((from.y > middle.y) == (to.y > middle.y)) continue;
    if ((turn(from, to, middle) > 0) == (to.y > from.y)) odd = !odd;
  }
  return odd;
}

/// Triangles on the same side of a line that share it and whose other sides do not cross lie in each other;
/// the smallest is the one that is empty.
std::uint32_t Greedy::apex(Side side, const std::vector<std::vector<std::uint32_t>>& neighbours) const {
  std::uint32_t best = no_index;
  std::int64_t least = 0;
  for (const std::uint32_t corner : neighbours[side.from]) {
    const auto& others = neighbours[side.to];
    if (std::find(others.begin(), others.end(), corner) == others.end()) continue;
    const std::int64_t area = turn(points_[side.from], points_[side.to], points_[corner]);
    if (area <= 0 || (best != no_index && area >= least)) continue;
    best = corner;
    least = area;
  }
  return best;
}

std::vector<std::array<std::uint32_t, 3>> Greedy::triangles() const {
  std::vector<std::vector<std::uint32_t>> neighbours(points_.size());
  std::vector<Side> ways = sides_;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    neighbours[sides_[i].from].push_back(sides_[i].to);
    neighbours[sides_[i].to].push_back(sides_[i].from);
    if (i >= border_) ways.push_back({sides_[i].to, sides_[i].from});
  }
  std::vector<std::array<std::uint32_t, 3>> result;
  for (const Side& way : ways) {
    const std::uint32_t corner = apex(way, neighbours);
    if (way.from < way.to && way.from < corner) result.push_back({way.from, way.to, corner});
  }
  return result;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Outline> loops) {
  Greedy greedy(loops);
  greedy.add_diagonals();
  return greedy.triangles();
}

}  // namespace cdfr
