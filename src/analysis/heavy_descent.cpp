#include "analysis/heavy_descent.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "analysis/cell_index.h"
#include "field/block_sides.h"
#include "field/query.h"
#include "geometry/box_distance.h"
#include "octree/search.h"

namespace cdfr {
namespace {

/// Lists beyond this are not taken: the cube is halved first.
constexpr std::size_t longest_list = 512;
/// Of the triangles that are tried in pairs.
constexpr std::size_t most_paired = 12;
/// Nearer to the surface than so many half diagonals, only the slope of 1 counts.
constexpr double near_surface = 1.125;
/// Shares of a direction below which a component is left out (cut_cube.h).
constexpr double least_share = 0x1p-20;

double sum_of_sizes(const Vec3& v) noexcept { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }
Vec3 minus(const Vec3& a, const Vec3& b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 plus(const Vec3& a, const Vec3& b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// As a float that is no less. Precondition: v >= 0.
float rounded_up(double v) noexcept { return static_cast<float>(v * (1 + 0x1p-22)); }

}  // namespace

Cube HeavyDescent::cube_of(const Cell& cell) const noexcept {
  const Lattice& lattice = field_.tree.lattice;
  return {lattice.box(cell).lo, lattice.size(cell.level)};
}

void HeavyDescent::run(const Cell& cell, std::span<const Entry> list, Side side) {
  if (side == Side::outside) return;
  const Cube cube = cube_of(cell);
  const double h = cube.half_diagonal();
  // A triangle comes in: no point of the cube is farther from it than the diagonal.
  if (side == Side::surface && 2 * h <= threshold_.depth) return;
  const Outlook outlook = blind(cube);
  const Sided sided = side == Side::inside ? Sided::inside : side_at(cube.centre(), outlook.distance, h);
  const Seen seen{fate_of(outlook, sided, h), sided, outlook, {}};
  if (seen.fate == Fate::drop) return;
  if (sided == Sided::inside && outlook.least > threshold_.depth) return put(cell, seen);
  if (!gather(list) && !gather_near(cube, outlook.distance)) return settle(cell, seen);
  take_list(cube);
  look_at(cell, sided);
}

void HeavyDescent::refine(const Cell& cell) {
  const Cube cube = cube_of(cell);
  const Outlook outlook = blind(cube);
  Seen seen{Fate::halve, side_at(cube.centre(), outlook.distance, cube.half_diagonal()), outlook, {}};
  if (seen.sided == Sided::outside) return;
  if (!gather_near(cube, outlook.distance)) return descend_blind(cell, seen.sided);
  take_list(cube);
  seen.numbers = all_;
  descend(cell, seen);
}

/// Without triangles inside, all of a cube is on its centre's side, unless the sign jumps.
HeavyDescent::Sided HeavyDescent::side_at(const Vec3& centre, double distance,
                                          double half_diagonal) const noexcept {
  const double radius = half_diagonal + threshold_.rounding;
  if (!(distance > radius)) return Sided::open;
  if (!threshold_.jumps) return signed_distance(field_, centre) < 0 ? Sided::inside : Sided::outside;
  const Side side = side_of_free_ball(field_, centre, radius);
  return side == Side::inside ? Sided::inside : side == Side::outside ? Sided::outside : Sided::open;
}

/// The leaf's own list, if it is no longer than that.
bool HeavyDescent::gather(std::span<const Entry> list) {
  slots_.clear();
  for (const Entry& entry : list) {
    const GroupRange groups = groups_of(field_.bvh, entry);
    if (std::size_t{groups.end - groups.first} * group_size > longest_list) return false;
    for (std::uint32_t group = groups.first; group < groups.end; ++group) {
      const unsigned own = entry.is_group() ? entry.lanes() : field_.triangles.own_lanes(group);
      for (unsigned lanes = own; lanes != 0; lanes &= lanes - 1)
        slots_.push_back(group * static_cast<std::uint32_t>(group_size) +
                         static_cast<std::uint32_t>(std::countr_zero(lanes)));
    }
    if (slots_.size() > longest_list) return false;
  }
  return !slots_.empty();
}

/// A triangle that is closest to x is no farther from x than d + h, so from the centre than d + 2 h.
bool HeavyDescent::gather_near(const Cube& cube, double distance) {
  slots_.clear();
  const double radius = distance + 2 * cube.half_diagonal() + threshold_.rounding;
  const Vec3 centre = cube.centre();
  return walk(
      field_.bvh, 0,
      [&](std::uint32_t node) {
        return squared_distance_below(centre, field_.bvh.nodes[node].box) <= radius * radius;
      },
      [&](std::uint32_t node) {
        const std::uint32_t group = field_.bvh.nodes[node].first_group;
        GroupDistances squared;
        estimate_squared(centre, field_.triangles.group(group), squared);
        for (std::size_t lane = 0; lane < field_.triangles.lanes(group); ++lane) {
          if (squared[lane] <= radius * radius)
            slots_.push_back(static_cast<std::uint32_t>(group * group_size + lane));
        }
        return slots_.size() <= longest_list;
      });
}

void HeavyDescent::take_list(const Cube& region) {
  middle_ = region.centre();
  error_ = 0;
  frames_.clear();
  for (const std::uint32_t slot : slots_) {
    frames_.push_back(triangle_frame(field_.triangles.shape(slot), middle_, 2 * region.half_diagonal()));
    error_ = std::max(error_, frames_.back().error + threshold_.rounding / 64);
  }
  all_.resize(slots_.size());
  std::iota(all_.begin(), all_.end(), std::uint16_t{0});
}

/// Distances of the centres, from each of the triangles.
void HeavyDescent::measure(std::span<const std::uint16_t> numbers) {
  eights_.resize(std::max(eights_.size(), numbers.size()));
  find_each_foot(frames_, numbers, centres_, eights_.data());
  out_.looks += centres_.count;
}

/// The cell itself, for which there is a list now.
void HeavyDescent::look_at(const Cell& cell, Sided sided) {
  const Cube cube = cube_of(cell);
  centres_.count = 0;
  centres_.add({});
  measure(all_);
  compare(cube.size, all_);
  Seen seen;
  see(0, cube.size, all_, sided, seen);
  if (seen.fate == Fate::halve) return descend(cell, seen);
  if (seen.fate == Fate::keep) put(cell, seen);
}

void HeavyDescent::see(std::size_t point, double size, std::span<const std::uint16_t> numbers, Sided above,
                       Seen& seen) {
  const double h = Cube{{}, size}.half_diagonal();
  seen.sided = above;
  seen.outlook = outlook(point, size, numbers, seen.numbers);
  seen.fate = fate_of(seen.outlook, above, h);
  if (seen.fate == Fate::drop || above != Sided::open) return;
  const Vec3 c = centres_.point(point);
  seen.sided = side_at(plus(middle_, c), seen.outlook.distance, h);
  seen.fate = fate_of(seen.outlook, seen.sided, h);
}

void HeavyDescent::descend(const Cell& cell, const Seen& seen) {
  if (!progress_.poll()) return;
  const Cube cube = cube_of(cell);
  centres_.count = 0;
  for (int child = 0; child < 8; ++child) centres_.add(minus(cube.octant(child).centre(), middle_));
  measure(seen.numbers);
  compare(cube.size / 2, seen.numbers);
  Octants& octants = levels_[static_cast<std::size_t>(cell.level) + 1];
  for (std::size_t child = 0; child < 8; ++child)
    see(child, cube.size / 2, seen.numbers, seen.sided, octants[child]);
  for (int child = 0; child < 8; ++child) {
    const Seen& octant = octants[static_cast<std::size_t>(child)];
    if (octant.fate == Fate::halve) {
      descend(child_of(cell, child), octant);
    } else if (octant.fate == Fate::keep) {
      put(child_of(cell, child), octant);
    }
  }
}

/// What has been seen of a cell without a list.
void HeavyDescent::settle(const Cell& cell, const Seen& seen) {
  if (seen.fate == Fate::keep) return put(cell, seen);
  if (seen.fate == Fate::halve) descend_blind(cell, seen.sided);
}

/// By the slope alone, until few enough triangles are near.
void HeavyDescent::descend_blind(const Cell& cell, Sided sided) {
  if (!progress_.poll()) return;
  for (int child = 0; child < 8; ++child) {
    const Cell octant = child_of(cell, child);
    const Cube cube = cube_of(octant);
    Seen seen{Fate::drop, sided, blind(cube), {}};
    if (sided == Sided::open)
      seen.sided = side_at(cube.centre(), seen.outlook.distance, cube.half_diagonal());
    seen.fate = fate_of(seen.outlook, seen.sided, cube.half_diagonal());
    if (seen.fate == Fate::halve && gather_near(cube, seen.outlook.distance)) {
      take_list(cube);
      look_at(octant, seen.sided);
    } else {
      settle(octant, seen);
    }
  }
}

HeavyDescent::Outlook HeavyDescent::blind(const Cube& cube) const noexcept {
  ++out_.looks;
  const double d = std::fabs(signed_distance(field_, cube.centre()));
  const double h = cube.half_diagonal() + threshold_.rounding / 4;
  return {d, {}, h, h, d - h, d + h};
}

/// The tangents l_k of all triangles with the closest one's, for cubes of that size, eight at a time.
void HeavyDescent::compare(double size, std::span<const std::uint16_t> numbers) {
  const double a = size / 2;
  std::array<double, 8> d, x, y, z;
  d.fill(HUGE_VAL);
  first_.fill(0);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    for (std::size_t p = 0; p < 8; ++p) {
      if (eights_[k].distance[p] < d[p]) first_[p] = k;
      d[p] = std::min(d[p], eights_[k].distance[p]);
    }
  }
  for (std::size_t p = 0; p < 8; ++p) {
    const Vec3 g = gradient(first_[p], p);
    x[p] = g.x;
    y[p] = g.y;
    z[p] = g.z;
  }
  least_.fill(HUGE_VAL);
  lower_.resize(std::max(lower_.size(), numbers.size()));
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const EightFeet& eight = eights_[k];
    std::array<double, 8>& lower = lower_[k];
    for (std::size_t p = 0; p < 8; ++p) {
      const double gx = eight.away[0][p], gy = eight.away[1][p], gz = eight.away[2][p];
      lower[p] = a * (std::fabs(gx - x[p]) + std::fabs(gy - y[p]) + std::fabs(gz - z[p])) -
                 (eight.distance[p] - d[p]);
      least_[p] =
          std::min(least_[p], eight.distance[p] - a * (std::fabs(gx) + std::fabs(gy) + std::fabs(gz)));
    }
  }
}

/// Precondition: compare.
HeavyDescent::Outlook HeavyDescent::outlook(std::size_t point, double size,
                                            std::span<const std::uint16_t> numbers,
                                            std::vector<std::uint16_t>& kept) const {
  const double a = size / 2, h = Cube{{}, size}.half_diagonal(), slack = 2 * error_;
  const std::size_t first = first_[point];
  const double d = eights_[first].distance[point];
  kept.clear();
  if (!(d > near_surface * h)) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (eights_[k].distance[point] <= d + 2 * h + slack) kept.push_back(numbers[k]);
    }
    return {d, {}, h + slack, h + slack, d - h - slack, d + h + slack};
  }
  const Vec3 g = gradient(first, point);
  Outlook o{d, g, 0, rise(first, point, numbers[first], h) + slack, 0, d + h + slack};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    o.below = std::max(o.below, lower_[k][point]);
    if (lower_[k][point] >= -o.above - slack) kept.push_back(numbers[k]);
  }
  o.below += slack;
  o.least = std::max(least_[point], d - h) - slack;
  o.most = std::min(o.most, d + a * sum_of_sizes(g) + o.above);
  if (d <= threshold_.depth && o.most > threshold_.depth)
    o.most = std::min(o.most, most_between(point, size, numbers));
  return o;
}

/// How much farther than its plane the triangle may be: o^2 / (2 (d - h)).
double HeavyDescent::rise(std::size_t place, std::size_t point, std::uint16_t number,
                          double half_diagonal) const noexcept {
  const EightFeet& eight = eights_[place];
  double inside = 0;
  if (eight.place[point] == 0) {
    const Vec3 p = centres_.point(point);
    inside = half_diagonal;
    for (const TriangleFrame::Edge& edge : frames_[number].edges) {
      const TriangleFrame::Axis& axis = edge.inwards;
      const double y = axis.way[0] * p.x + axis.way[1] * p.y + axis.way[2] * p.z - axis.start;
      inside = std::min(inside, std::max(0.0, y - error_));
    }
  }
  const double beyond = half_diagonal - inside;
  return beyond * beyond / (2 * (eight.distance[point] - half_diagonal)) * (1 + 0x1p-40);
}

/// The least mean of two upper bounds.
double HeavyDescent::most_between(std::size_t point, double size,
                                  std::span<const std::uint16_t> numbers) const noexcept {
  const double a = size / 2, h = Cube{{}, size}.half_diagonal();
  struct Upper {
    double middle;
    Vec3 gradient;
  };
  std::array<Upper, most_paired> uppers;
  const std::size_t count = std::min(numbers.size(), most_paired);
  double most = HUGE_VAL;
  for (std::size_t k = 0; k < count; ++k) {
    uppers[k] = {eights_[k].distance[point] + rise(k, point, numbers[k], h), gradient(k, point)};
    for (std::size_t j = 0; j < k; ++j) {
      const double mean = (uppers[j].middle + uppers[k].middle) / 2 +
                          a * sum_of_sizes(plus(uppers[j].gradient, uppers[k].gradient)) / 2;
      most = std::min(most, mean);
    }
  }
  return most + 2 * error_;
}

HeavyDescent::Fate HeavyDescent::fate_of(const Outlook& outlook, Sided sided,
                                         double half_diagonal) const noexcept {
  if (sided == Sided::outside || outlook.most <= threshold_.depth + threshold_.rounding) return Fate::drop;
  if (half_diagonal <= threshold_.error) return Fate::keep;
  if (sided == Sided::open) return Fate::halve;
  if (outlook.least > threshold_.depth || outlook.above + outlook.below <= threshold_.flat) return Fate::keep;
  return Fate::halve;
}

/// In edges of the lattice, as floats: what rounds is added to the bounds.
void HeavyDescent::put(const Cell& cell, const Seen& seen) {
  const double scale = 1 / field_.tree.lattice.edge, a = cube_of(cell).size / 2;
  Outlook o = seen.outlook;
  const bool is_inner = seen.sided == Sided::inside && o.least > threshold_.depth;
  if (is_inner) o = {o.distance, {}, o.distance - o.least, o.most - o.distance, o.least, o.most};
  if (seen.sided == Sided::open) {
    // Of such a cell only the centre's own depth is sure, and where the sign jumps nothing is.
    const double h = Cube{{}, 2 * a}.half_diagonal() + threshold_.rounding / 4, most = o.distance + h;
    if (!threshold_.jumps) o.distance = -signed_distance(field_, cube_of(cell).centre());
    o = {o.distance, {}, h, h, o.distance - h, o.distance + h};
    if (threshold_.jumps) o = {threshold_.depth - h, {}, h, most - threshold_.depth + h, 0, most};
    if (o.most <= threshold_.depth + threshold_.rounding) return;
  }
  HeavyCell kept{key_of(cell)};
  const double over = (o.distance - threshold_.depth) * scale;
  kept.over = static_cast<float>(over);
  double off = std::fabs(over - double{kept.over});
  const double way[3] = {o.gradient.x, o.gradient.y, o.gradient.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    kept.gradient[axis] = std::fabs(way[axis]) < least_share ? 0 : static_cast<float>(way[axis]);
    off += std::fabs(way[axis] - double{kept.gradient[axis]}) * a * scale;
  }
  kept.below = rounded_up(o.below * scale + off);
  kept.above = rounded_up(o.above * scale + off);
  if (!is_inner) {
    for (const std::uint16_t number : seen.numbers) tell(slots_[number], kept);
    if (seen.numbers.empty()) tell(find_closest(field_, cube_of(cell).centre()).winner.slot, kept);
  }
  out_.cells.push_back(kept);
}

/// Of the cell that comes next. One that surely hangs together with the last one told says nothing new.
void HeavyDescent::tell(std::uint32_t slot, const HeavyCell& cell) {
  CellTriangle& last = told_[slot % told_.size()];
  if (last.slot == slot && cores_join(rule_, out_.cells[last.cell], cell)) return;
  last = {static_cast<std::uint32_t>(out_.cells.size()), slot};
  out_.triangles.push_back(last);
}

}  // namespace cdfr
