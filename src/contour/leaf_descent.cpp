#include "contour/leaf_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/vector.h"
#include "field/batch.h"
#include "field/query.h"

namespace cdfr {
namespace {

/// Cubes of final size along a tile: its triangles are chosen once for all of them.
constexpr double tile_side = 8;
/// A point is moved by half a diagonal at most, sqrt(3)/2 s from the centre of a cube that reaches s/2.
constexpr double grown_by = 0.4;
/// Below so many roundings the general way is as good, and its errors are smaller.
constexpr double least_tolerance = 1024;
/// How often a point is moved away from one sheet after another.
constexpr int most_rounds = 4;
/// Triangles of a list whose distances at the corners may show that the contour is not in the cube.
constexpr std::size_t most_tried = 16;
constexpr std::uint32_t not_asked = no_index;

template <class Ids>
bool among(std::uint32_t id, const Ids& ids) noexcept {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// The edge or vertex at that place of the first one; for the face, all corners.
bool shares(const TriangleRecord& own, const TriangleRecord& other, TrianglePlace place) noexcept {
  if (place >= 4) return among(own.vertices[place - 4], other.vertices);
  if (place > 0) return among(own.edges[place - 1], other.edges);
  return among(own.vertices[0], other.vertices) && among(own.vertices[1], other.vertices) &&
         among(own.vertices[2], other.vertices);
}

}  // namespace

LeafDescent::LeafDescent(const FieldData& field, const Level& level, Descent& single,
                         std::vector<ContourPoint>& points)
    : field_(field), level_(level), single_(single), points_(points) {}

LeafDescent::Sided LeafDescent::side_in(const Region& region) const noexcept {
  if (field_.sign == Sign::none) return Sided::right;
  if (region.side != Side::inside && region.side != Side::outside) return Sided::open;
  return region.side == level_.other_side() ? Sided::wrong : Sided::right;
}

bool LeafDescent::run(const Region& region) {
  const bool is_too_fine = level_.tolerance < least_tolerance * level_.rounding;
  if (level_.height == 0 || region.list.empty() || is_too_fine) return false;
  // The paper's rule takes centres on the other side as well.
  if (level_.rule == Rule::paper && level_.height < level_.tolerance) return false;
  const Sided sided = side_in(region);
  if (sided == Sided::open && level_.jumps) return false;
  if (sided == Sided::wrong) return true;
  const Lattice& lattice = field_.tree.lattice;
  const double scale = 1 / lattice.edge;
  region_ = region.cube;
  middle_ = region.cube.centre();
  radius_ = 2 * region.cube.half_diagonal();
  const Vec3 from_origin{middle_.x - lattice.origin.x, middle_.y - lattice.origin.y,
                         middle_.z - lattice.origin.z};
  const Vec3 in_edges{from_origin.x * scale, from_origin.y * scale, from_origin.z * scale};
  if (!list_.fill(field_.triangles, lattice, region.list, in_edges, radius_ * scale)) return false;
  final_size_ = final_size(level_, region.cube.size);
  error_ = 0;
  const std::size_t count = list_.triangles.size();
  frames_.resize(count);
  framed_.assign(count, false);
  base_.resize(count);
  std::array<std::uint16_t, TileList::most> numbers;
  std::iota(numbers.begin(), numbers.end(), std::uint16_t{0});
  descend(region.cube, {numbers.data(), count}, sided);
  check_beyond_region();
  redo_failed();
  return true;
}

void LeafDescent::make_frames(FrameNumbers numbers) {
  for (const std::uint16_t n : numbers) {
    if (framed_[n]) continue;
    framed_[n] = true;
    frames_[n] = triangle_frame(field_.triangles.shape(list_.slots[n]), middle_, radius_);
    base_[n].fill(not_asked);
    error_ = std::max(error_, frames_[n].error + level_.rounding / 4);
  }
}

FrameNumbers LeafDescent::pruned(const Cube& cube, FrameNumbers numbers, std::uint16_t* kept) const noexcept {
  if (numbers.size() <= 2) return numbers;
  const double scale = 1 / field_.tree.lattice.edge, more = grown_by * final_size_;
  const Vec3 lo = from_middle(cube.lo);
  const double corner[3] = {lo.x, lo.y, lo.z};
  TileBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lo[axis] = static_cast<float>((corner[axis] - more) * scale);
    box.hi[axis] = static_cast<float>((corner[axis] + cube.size + more) * scale);
  }
  return {kept, prune(list_, numbers, box, kept)};
}

/// A cube that no triangle enters is on one side.
LeafDescent::Sided LeafDescent::side_of(const Cube& cube, double distance) noexcept {
  if (!(distance > cube.half_diagonal() + error_)) return Sided::open;
  ++counts_.evaluations;
  return level_.on_side(signed_distance(field_, cube.centre())) ? Sided::right : Sided::wrong;
}

void LeafDescent::descend(const Cube& cube, FrameNumbers numbers, Sided sided) {
  if (sided == Sided::right && cube.size <= tile_side * final_size_) return tile(cube, numbers);
  if (cube.size <= final_size_) return single_.finish(cube);
  make_frames(numbers);
  octants_.count = 0;
  for (int child = 0; child < 8; ++child) octants_.add(from_middle(cube.octant(child).centre()));
  squared_distances(frames_, numbers, octants_, squared_.data());
  counts_.evaluations += 8;
  std::array<double, 8> squared;
  std::copy_n(squared_.begin(), 8, squared.begin());
  for (int child = 0; child < 8; ++child) {
    const Cube octant = cube.octant(child);
    const double distance = std::sqrt(squared[static_cast<std::size_t>(child)]);
    if (std::fabs(distance - level_.height) > level_.reach(octant.half_diagonal()) + error_) continue;
    const Sided own = sided == Sided::open ? side_of(octant, distance) : sided;
    if (own == Sided::wrong) continue;
    std::array<std::uint16_t, TileList::most> kept;
    descend(octant, pruned(octant, numbers, kept.data()), own);
  }
}

/// A cube on the contour's side.
void LeafDescent::tile(const Cube& cube, FrameNumbers numbers) {
  make_frames(numbers);
  centres_.count = 0;
  centres_.add(from_middle(cube.centre()));
  for (double size = cube.size; size > final_size_;) {
    size /= 2;
    halve(size);
    if (size > final_size_) {
      keep_passing(size, numbers);
    } else {
      std::swap(centres_, octants_);
    }
  }
  for (std::size_t first = 0; first < centres_.count; first += Feet::most) finish(first, numbers);
}

/// The octants, of that size, of all cubes.
void LeafDescent::halve(double size) {
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < centres_.count; ++i) {
      const double lo = centres_.at[axis][i] - size / 2, hi = centres_.at[axis][i] + size / 2;
      for (std::size_t child = 0; child < 8; ++child)
        octants_.at[axis][8 * i + child] = (child >> axis & 1U) != 0 ? hi : lo;
    }
  }
  octants_.count = 8 * centres_.count;
}

/// Of the octants.
void LeafDescent::keep_passing(double size, FrameNumbers numbers) {
  squared_distances(frames_, numbers, octants_, squared_.data());
  counts_.evaluations += octants_.count;
  const double most = level_.reach(Cube{{}, size}.half_diagonal()) + error_;
  const double lo = std::max(0.0, level_.height - most) * (1 - 4 * unit_roundoff);
  const double hi = (level_.height + most) * (1 + 4 * unit_roundoff);
  centres_.count = 0;
  for (std::size_t i = 0; i < octants_.count; ++i) {
    if (squared_[i] >= lo * lo && squared_[i] <= hi * hi) centres_.add(octants_.point(i));
  }
}

/// At most Feet::most cubes of final size.
void LeafDescent::finish(std::size_t first, FrameNumbers numbers) {
  find_feet(frames_, numbers, centres_, first, feet_);
  const std::size_t count = std::min(Feet::most, centres_.count - first);
  counts_.evaluations += count;
  const double most = level_.reach(Cube{{}, final_size_}.half_diagonal()) + error_;
  moved_.count = 0;
  moved_from_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    if (std::fabs(feet_.distance[i] - level_.height) <= most) put(i, centres_.point(first + i), numbers);
  }
  check_moved(numbers);
}

/// Of a point that is to move away from its foot by so much.
double LeafDescent::error_of(double move) const noexcept {
  if (level_.rule == Rule::paper) return move > 0 ? std::numeric_limits<double>::infinity() : error_ - move;
  return move > 0 ? 2 * error_ : error_;
}

/// The point at the height, on the ray from the foot of `from` through it. Nothing if its triangle has no
/// area, or the distance tells no direction.
std::optional<LeafDescent::Moved> LeafDescent::moved(std::size_t i, const Vec3& from) {
  const auto number = static_cast<std::size_t>(feet_.number[i]);
  if (std::isinf(frames_[number].doubt) || !(feet_.distance[i] > error_)) return std::nullopt;
  const Vec3 away{feet_.away[0][i], feet_.away[1][i], feet_.away[2][i]};
  const double move = level_.height - feet_.distance[i];
  const auto moved_by = [&](double length) {
    return Vec3{from.x + length * away.x, from.y + length * away.y, from.z + length * away.z};
  };
  const Vec3 x = level_.rule == Rule::paper ? from : moved_by(move);
  return Moved{{{middle_.x + x.x, middle_.y + x.y, middle_.z + x.z},
                {level_.side * away.x, level_.side * away.y, level_.side * away.z},
                base_triangle(number, static_cast<TrianglePlace>(feet_.place[i])),
                error_of(move)},
               move,
               moved_by(move + 1.5 * error_)};
}

bool LeafDescent::in_region(const Vec3& x) const noexcept {
  return std::max({std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)}) <= region_.size / 2;
}

void LeafDescent::put(std::size_t i, const Vec3& centre, FrameNumbers numbers) {
  const std::optional<Moved> moved = this->moved(i, centre);
  const Placed placed{centre, points_.size(), moved.has_value()};
  if (!moved) return failed_.push_back(placed);
  points_.push_back(moved->point);
  if (moved->by <= 0 || level_.rule == Rule::paper) return;
  if (!in_region(moved->beyond)) {
    beyond_.push_back(placed);
  } else if (numbers.size() > 1) {
    moved_from_.push_back(placed);
    moved_.add(moved->beyond);
  }
}

/// A point that came too close to another sheet, moved away from that one: near an edge of the contour that
/// is often a point of it. False if that leads out of what the cube's list and tolerance cover.
bool LeafDescent::put_again(std::size_t i, const Placed& placed) {
  const std::optional<Moved> moved = this->moved(i, again_.point(i));
  if (!moved || !in_region(moved->beyond)) return false;
  const Vec3 off{moved->beyond.x - placed.centre.x, moved->beyond.y - placed.centre.y,
                 moved->beyond.z - placed.centre.z};
  const double reach = (0.5 + grown_by) * final_size_, half = level_.tolerance / 2;
  if (std::max({std::fabs(off.x), std::fabs(off.y), std::fabs(off.z)}) > reach) return false;
  if (off.x * off.x + off.y * off.y + off.z * off.z > half * half) return false;
  points_[placed.point] = moved->point;
  points_[placed.point].error = 2 * error_;
  moved_.add(moved->beyond);
  moved_from_.push_back(placed);
  return true;
}

/// The value a hair beyond a point, which has to reach the height by more than its own error, tells that the
/// contour passes in between.
void LeafDescent::check_moved(FrameNumbers numbers) {
  const double least = (level_.height + error_) * (1 + 4 * unit_roundoff);
  for (int round = 0; moved_.count > 0; ++round) {
    squared_distances(frames_, numbers, moved_, squared_.data());
    counts_.evaluations += moved_.count;
    again_.count = 0;
    again_from_.clear();
    for (std::size_t i = 0; i < moved_.count; ++i) {
      if (squared_[i] >= least * least) continue;
      again_.add(moved_.point(i));
      again_from_.push_back(moved_from_[i]);
    }
    moved_.count = 0;
    moved_from_.clear();
    if (again_.count == 0) return;
    if (round < most_rounds) find_feet(frames_, numbers, again_, 0, feet_);
    for (std::size_t i = 0; i < again_.count; ++i) {
      Placed& placed = again_from_[i];
      if (round < most_rounds && put_again(i, placed)) continue;
      placed.is_excluded = is_below(placed.centre, numbers);
      failed_.push_back(placed);
    }
  }
}

/// True if no point of the cube of final size around that centre is as far from the surface as the height:
/// distance_above's bound, for triangles of the list.
bool LeafDescent::is_below(const Vec3& centre, FrameNumbers numbers) {
  const double half = final_size_ / 2, height = level_.height - error_;
  octants_.count = 0;
  for (int corner = 0; corner < 8; ++corner) {
    octants_.add({centre.x + (corner & 1 ? half : -half), centre.y + (corner & 2 ? half : -half),
                  centre.z + (corner & 4 ? half : -half)});
  }
  const std::size_t count = std::min(numbers.size(), most_tried);
  std::array<std::array<double, 8>, most_tried> at;
  for (std::size_t k = 0; k < count; ++k) {
    squared_distances(frames_, numbers.subspan(k, 1), octants_, squared_.data());
    for (std::size_t corner = 0; corner < 8; ++corner) at[k][corner] = std::sqrt(squared_[corner]);
    // With itself, then with each of the others, half and half.
    for (std::size_t other = 0; other <= k; ++other) {
      double most = 0;
      for (std::size_t corner = 0; corner < 8; ++corner)
        most = std::max(most, (at[k][corner] + at[other][corner]) / 2);
      if (most < height) return true;
    }
  }
  return false;
}

void LeafDescent::check_beyond_region() {
  if (beyond_.empty()) return;
  std::vector<Vec3> beyond;
  for (const Placed& placed : beyond_) {
    const ContourPoint& point = points_[placed.point];
    const double step = level_.side * 1.5 * error_;
    const Vec3 &x = point.position, &n = point.normal;
    beyond.push_back({x.x + step * n.x, x.y + step * n.y, x.z + step * n.z});
  }
  std::vector<double> distances(beyond.size());
  const Run silent;
  Progress progress(silent);
  answer(field_, Points(beyond), 0, std::span<double>(distances), progress);
  counts_.evaluations += beyond.size();
  for (std::size_t i = 0; i < beyond.size(); ++i) {
    if (!(std::fabs(distances[i]) >= level_.height + error_)) failed_.push_back(beyond_[i]);
  }
  beyond_.clear();
}

/// The general way for what failed, each point in its place.
void LeafDescent::redo_failed() {
  if (failed_.empty()) return;
  std::stable_sort(failed_.begin(), failed_.end(),
                   [](const Placed& a, const Placed& b) { return a.point < b.point; });
  before_.swap(points_);
  points_.clear();
  const double half = final_size_ / 2;
  std::size_t next = 0;
  const auto keep_until = [&](std::size_t end) {
    points_.insert(points_.end(), before_.begin() + static_cast<std::ptrdiff_t>(next),
                   before_.begin() + static_cast<std::ptrdiff_t>(end));
  };
  for (const Placed& placed : failed_) {
    keep_until(placed.point);
    next = placed.point + (placed.is_there ? 1 : 0);
    const Vec3 c{middle_.x + placed.centre.x, middle_.y + placed.centre.y, middle_.z + placed.centre.z};
    if (!placed.is_excluded) single_.finish({{c.x - half, c.y - half, c.z - half}, final_size_});
  }
  keep_until(before_.size());
  failed_.clear();
}

std::uint32_t LeafDescent::base_triangle(std::size_t number, TrianglePlace place) {
  std::uint32_t& base = base_[number][place];
  if (base == not_asked) base = lowest_at(number, place);
  return base;
}

/// The lowest of the triangles that share the feature, which are equally close; all of them are in the list.
std::uint32_t LeafDescent::lowest_at(std::size_t number, TrianglePlace place) const noexcept {
  const TriangleRecord& own = field_.triangles.records[list_.slots[number]];
  std::uint32_t lowest = own.number;
  for (const std::uint32_t slot : list_.slots) {
    const TriangleRecord& other = field_.triangles.records[slot];
    if (other.number > lowest || !shares(own, other, place)) continue;
    const bool has_area = !(rounded(field_.triangles.shape(slot).normal) == Vec3{});
    if (has_area) lowest = other.number;
  }
  return lowest;
}

}  // namespace cdfr
