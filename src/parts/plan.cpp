#include "parts/plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace cdfr {
namespace {

using Side = std::pair<PlanPoint, PlanPoint>;

constexpr double merge = plan_units / 4;

double length_between(PlanPoint a, PlanPoint b) noexcept {
  const auto x = static_cast<double>(b.x - a.x);
  const auto y = static_cast<double>(b.y - a.y);
  return std::sqrt(x * x + y * y);
}

PlanPoint along(Side side, double share) noexcept {
  const auto [a, b] = side;
  return plan_point((static_cast<double>(a.x) + share * static_cast<double>(b.x - a.x)) / plan_units,
                    (static_cast<double>(a.y) + share * static_cast<double>(b.y - a.y)) / plan_units);
}

/// The point's place along the side, 0 to 1, or -1 if it is farther than `merge` from the side's inner part.
double place_on(Side side, PlanPoint point) noexcept {
  const auto [a, b] = side;
  const double length = length_between(a, b);
  if (std::abs(static_cast<double>(turn(a, b, point))) > merge * length) return -1;
  const double share = (static_cast<double>(point.x - a.x) * static_cast<double>(b.x - a.x) +
                        static_cast<double>(point.y - a.y) * static_cast<double>(b.y - a.y)) /
                       (length * length);
  return share > 0 && share < 1 ? share : -1;
}

bool apart(Side s, Side t) noexcept {
  const auto gap = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return std::max(a, b) < std::min(c, d) - 256 || std::max(c, d) < std::min(a, b) - 256;
  };
  return gap(s.first.x, s.second.x, t.first.x, t.second.x) ||
         gap(s.first.y, s.second.y, t.first.y, t.second.y);
}

/// Corners and crossings, none closer than `merge` to an earlier one.
class Corners {
 public:
  PlanPoint add(PlanPoint point) {
    const auto bucket = [](std::int64_t v) { return v / 4096; };
    for (std::int64_t x = bucket(point.x) - 1; x <= bucket(point.x) + 1; ++x) {
      for (std::int64_t y = bucket(point.y) - 1; y <= bucket(point.y) + 1; ++y) {
        for (const PlanPoint known : buckets_[{x, y}]) {
          if (length_between(known, point) < merge) return known;
        }
      }
    }
    buckets_[{bucket(point.x), bucket(point.y)}].push_back(point);
    points_.push_back(point);
    return point;
  }
  const std::vector<PlanPoint>& points() const noexcept { return points_; }

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<PlanPoint>> buckets_;
  std::vector<PlanPoint> points_;
};

std::vector<Side> sides_of(std::span<const Outline> outlines, Corners& corners) {
  std::vector<Side> sides;
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Side side{corners.add(outline[i]), corners.add(outline[(i + 1) % outline.size()])};
      if (side.first != side.second) sides.push_back(side);
    }
  }
  return sides;
}

void add_crossings(const std::vector<Side>& sides, Corners& corners) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      if (apart(sides[i], sides[j])) continue;
      const auto [a, b] = sides[i];
      const auto [c, d] = sides[j];
      const std::int64_t from = turn(c, d, a);
      const std::int64_t to = turn(c, d, b);
      const std::int64_t other_from = turn(a, b, c);
      const std::int64_t other_to = turn(a, b, d);
      const bool cross = ((from < 0 && to > 0) || (from > 0 && to < 0)) &&
                         ((other_from < 0 && other_to > 0) || (other_from > 0 && other_to < 0));
      if (cross) corners.add(along(sides[i], static_cast<double>(from) / static_cast<double>(from - to)));
    }
  }
}

/// Sides cut at every corner that lies on them, and long ones further into pieces of about `spacing`.
std::vector<Side> cut_sides(const std::vector<Side>& sides, const std::vector<PlanPoint>& corners,
                            double spacing) {
  std::vector<Side> pieces;
  for (const Side& side : sides) {
    std::vector<std::pair<double, PlanPoint>> cuts{{0, side.first}, {1, side.second}};
    for (const PlanPoint corner : corners) {
      if (corner == side.first || corner == side.second || apart(side, {corner, corner})) continue;
      const double place = place_on(side, corner);
      if (place > 0) cuts.emplace_back(place, corner);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const Side piece{cuts[i].second, cuts[i + 1].second};
      const long count = std::max(1L, std::lround(length_between(piece.first, piece.second) / spacing));
      PlanPoint last = piece.first;
      for (long k = 1; k <= count; ++k) {
        const PlanPoint next =
            k == count ? piece.second : along(piece, static_cast<double>(k) / static_cast<double>(count));
        pieces.push_back(std::minmax(last, next));
        last = next;
      }
    }
  }
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  return pieces;
}

/// Points of a triangular lattice that keep 3/4 of the spacing from every side's ends.
std::vector<PlanPoint> filling(PlanPoint far, const std::vector<Side>& sides, double spacing) {
  std::vector<PlanPoint> points;
  const double row = spacing * 0.875;
  const double clear = spacing * 0.75;
  std::vector<PlanPoint> ends;
  for (const Side& side : sides) {
    ends.push_back(side.first);
    ends.push_back(side.second);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (int j = 1; j * row < static_cast<double>(far.y); ++j) {
    for (int i = 1; (i + 0.5) * spacing < static_cast<double>(far.x); ++i) {
      const PlanPoint point{static_cast<std::int64_t>((i + (j % 2) * 0.5) * spacing),
                            static_cast<std::int64_t>(j * row)};
      const auto reach = static_cast<std::int64_t>(clear) + 1;
      auto end = std::lower_bound(ends.begin(), ends.end(), PlanPoint{point.x - reach, 0});
      while (end != ends.end() && end->x <= point.x + reach && length_between(*end, point) >= clear) ++end;
      if (end == ends.end() || end->x > point.x + reach) points.push_back(point);
    }
  }
  return points;
}

/// Inserts the middle of every side that the triangulation lacks until none is lacking. A side is there as
/// soon as no point lies in the circle over it, so short enough pieces always are.
void recover(Delaunay& delaunay, std::vector<Side> wanted) {
  while (!wanted.empty()) {
    std::vector<Side> present;
    const std::vector<PlanPoint>& points = delaunay.points();
    for (const auto& corners : delaunay.triangles()) {
      for (std::size_t i = 0; i < 3; ++i) {
        present.push_back(std::minmax(points[corners[i]], points[corners[(i + 1) % 3]]));
      }
    }
    std::sort(present.begin(), present.end());
    std::vector<Side> halves;
    for (const Side& side : wanted) {
      if (std::binary_search(present.begin(), present.end(), side)) continue;
      const PlanPoint middle = along(side, 0.5);
      delaunay.insert(middle);
      halves.push_back(std::minmax(side.first, middle));
      halves.push_back(std::minmax(middle, side.second));
    }
    // An insertion can have taken away a side that was there, so those are looked at again as long as any is
    // cut.
    if (halves.empty()) return;
    std::erase_if(
        wanted, [&](const Side& side) { return !std::binary_search(present.begin(), present.end(), side); });
    wanted.insert(wanted.end(), halves.begin(), halves.end());
  }
}

}  // namespace

Plan make_plan(PlanPoint far, std::span<const Outline> outlines, double spacing) {
  const double step = spacing * plan_units;
  Corners corners;
  std::vector<Side> sides = sides_of(outlines, corners);
  add_crossings(sides, corners);
  sides = cut_sides(sides, corners.points(), step);
  Delaunay delaunay(far);
  for (const Side& side : sides) {
    delaunay.insert(side.first);
    delaunay.insert(side.second);
  }
  for (const PlanPoint point : filling(far, sides, step)) delaunay.insert(point);
  recover(delaunay, std::move(sides));
  return {delaunay.points(), delaunay.triangles()};
}

}  // namespace cdfr
