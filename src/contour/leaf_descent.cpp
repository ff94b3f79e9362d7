#include "contour/leaf_descent.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/vector.h"
#include "field/query.h"

namespace cdfr {
namespace {

/// Cubes of final size along a tile: its triangles are chosen once for all of them.
constexpr double tile_side = 8;
/// A point is moved by half a diagonal at most, sqrt(3)/2 s from the centre of a cube that reaches s/2.
constexpr double grown_by = 0.4;
/// Below so many roundings the general way is as good, and its errors are smaller.
constexpr double least_tolerance = 1024;
constexpr std::uint32_t not_asked = no_index;

bool holds(const Cube& cube, const Vec3& x) noexcept {
  const auto within = [&](double at, double lo) { return at >= lo && at <= lo + cube.size; };
  return within(x.x, cube.lo.x) && within(x.y, cube.lo.y) && within(x.z, cube.lo.z);
}

template <class Ids>
bool among(std::uint32_t id, const Ids& ids) noexcept {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

LeafDescent::LeafDescent(const FieldData& field, const Level& level, double tolerance, Descent& single,
                         std::vector<ContourPoint>& points)
    : field_(field), level_(level), tolerance_(tolerance), single_(single), points_(points) {}

bool LeafDescent::run(const Region& region) {
  if (level_.height == 0 || region.list.empty() || tolerance_ < least_tolerance * level_.rounding)
    return false;
  Sided sided = Sided::open;
  if (field_.sign == Sign::none) {
    sided = Sided::right;
  } else if (region.side == Side::inside || region.side == Side::outside) {
    sided = region.side == level_.other_side() ? Sided::wrong : Sided::right;
  } else if (level_.jumps) {
    return false;
  }
  if (sided == Sided::wrong) return true;
  const Lattice& lattice = field_.tree.lattice;
  const double scale = 1 / lattice.edge;
  middle_ = region.cube.centre();
  radius_ = 2 * region.cube.half_diagonal();
  const Vec3 in_edges{(middle_.x - lattice.origin.x) * scale, (middle_.y - lattice.origin.y) * scale,
                      (middle_.z - lattice.origin.z) * scale};
  if (!list_.fill(field_.triangles, lattice, region.list, in_edges, radius_ * scale)) return false;
  region_ = region.cube;
  final_size_ = region.cube.size;
  while (Cube{{}, final_size_}.half_diagonal() > tolerance_ / 2) final_size_ /= 2;
  frames_.resize(list_.triangles.size());
  framed_.assign(list_.triangles.size(), false);
  base_.resize(list_.triangles.size());
  error_ = 0;
  std::array<std::uint16_t, TileList::most> numbers;
  std::iota(numbers.begin(), numbers.end(), std::uint16_t{0});
  descend(region.cube, {numbers.data(), list_.triangles.size()}, sided);
  return true;
}

bool LeafDescent::may_enter(double distance, const Cube& cube) const noexcept {
  return std::fabs(distance - level_.height) <= cube.half_diagonal() + error_;
}

void LeafDescent::add_centre(const Cube& cube, RegionPoints& points) const noexcept {
  const Vec3 c = cube.centre();
  points.add(c.x - middle_.x, c.y - middle_.y, c.z - middle_.z);
}

void LeafDescent::make_frames(TileNumbers numbers) {
  for (const std::uint16_t n : numbers) {
    if (framed_[n]) continue;
    framed_[n] = true;
    frames_[n] = triangle_frame(field_.triangles.shape(list_.slots[n]), middle_, radius_);
    base_[n].fill(not_asked);
    error_ = std::max(error_, frames_[n].error + level_.rounding / 4);
  }
}

TileNumbers LeafDescent::pruned(const Cube& cube, TileNumbers numbers, std::uint16_t* kept) const noexcept {
  if (numbers.size() <= 2) return numbers;
  const double scale = 1 / field_.tree.lattice.edge, more = grown_by * final_size_;
  const double lo[3] = {cube.lo.x - middle_.x, cube.lo.y - middle_.y, cube.lo.z - middle_.z};
  TileBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lo[axis] = static_cast<float>((lo[axis] - more) * scale);
    box.hi[axis] = static_cast<float>((lo[axis] + cube.size + more) * scale);
  }
  return {kept, prune(list_, numbers, box, kept)};
}

/// A cube that no triangle enters is on one side.
LeafDescent::Sided LeafDescent::side_of(const Cube& cube, double distance) noexcept {
  if (!(distance > cube.half_diagonal() + error_)) return Sided::open;
  ++counts_.evaluations;
  return level_.on_side(signed_distance(field_, cube.centre())) ? Sided::right : Sided::wrong;
}

void LeafDescent::descend(const Cube& cube, TileNumbers numbers, Sided sided) {
  if (sided == Sided::right && cube.size <= tile_side * final_size_) return tile(cube, numbers);
  if (cube.size <= final_size_) return single_.finish(cube);
  make_frames(numbers);
  RegionPoints centres;
  centres.count = 0;
  for (int child = 0; child < 8; ++child) add_centre(cube.octant(child), centres);
  alignas(64) double squared[RegionPoints::most];
  squared_distances(frames_, numbers, centres, squared);
  counts_.evaluations += 8;
  for (int child = 0; child < 8; ++child) {
    const Cube octant = cube.octant(child);
    const double distance = std::sqrt(squared[child]);
    if (!may_enter(distance, octant)) continue;
    const Sided own = sided == Sided::open ? side_of(octant, distance) : sided;
    if (own == Sided::wrong) continue;
    std::array<std::uint16_t, TileList::most> kept;
    descend(octant, pruned(octant, numbers, kept.data()), own);
  }
}

void LeafDescent::tile(const Cube& cube, TileNumbers numbers) {
  make_frames(numbers);
  cubes_.assign(1, cube);
  for (double size = cube.size; size > final_size_;) {
    size /= 2;
    octants_.clear();
    for (const Cube& whole : cubes_) {
      for (int child = 0; child < 8; ++child) octants_.push_back(whole.octant(child));
    }
    if (size > final_size_) {
      keep_passing(numbers);
    } else {
      std::swap(cubes_, octants_);
    }
  }
  const std::span<const Cube> cubes = cubes_;
  for (std::size_t first = 0; first < cubes.size(); first += RegionPoints::most)
    finish(cubes.subspan(first, std::min(RegionPoints::most, cubes.size() - first)), numbers);
}

/// Of the octants.
void LeafDescent::keep_passing(TileNumbers numbers) {
  cubes_.clear();
  alignas(64) double squared[RegionPoints::most];
  for (std::size_t first = 0; first < octants_.size(); first += RegionPoints::most) {
    const std::size_t end = std::min(first + RegionPoints::most, octants_.size());
    RegionPoints centres;
    centres.count = 0;
    for (std::size_t i = first; i < end; ++i) add_centre(octants_[i], centres);
    squared_distances(frames_, numbers, centres, squared);
    for (std::size_t i = first; i < end; ++i) {
      if (may_enter(std::sqrt(squared[i - first]), octants_[i])) cubes_.push_back(octants_[i]);
    }
  }
  counts_.evaluations += octants_.size();
}

/// At most RegionPoints::most cubes of final size.
void LeafDescent::finish(std::span<const Cube> cubes, TileNumbers numbers) {
  RegionPoints centres;
  centres.count = 0;
  for (const Cube& cube : cubes) add_centre(cube, centres);
  find_feet(frames_, numbers, centres, feet_);
  counts_.evaluations += cubes.size();
  bool some_moved = false;
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    outcomes_[i] = outcome(cubes[i], i, found_[i]);
    some_moved |= outcomes_[i] == Outcome::moved_away;
  }
  if (some_moved) check_moved(numbers, cubes.size());
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    if (outcomes_[i] == Outcome::point) points_.push_back(found_[i]);
    if (outcomes_[i] == Outcome::single) single_.finish(cubes[i]);
  }
}

LeafDescent::Outcome LeafDescent::outcome(const Cube& cube, std::size_t i, ContourPoint& point) {
  const double distance = std::sqrt(feet_.squared[i]);
  if (!may_enter(distance, cube)) return Outcome::none;
  const auto number = static_cast<std::size_t>(feet_.number[i]);
  const auto place = static_cast<TrianglePlace>(feet_.place[i]);
  const TriangleFrame& frame = frames_[number];
  if (std::isinf(frame.doubt) || !(distance > error_)) return Outcome::single;
  Vec3 away{feet_.offset[0][i] / distance, feet_.offset[1][i] / distance, feet_.offset[2][i] / distance};
  if (place == 0) {
    const auto& n = frame.height.way;
    const double above = away.x * n[0] + away.y * n[1] + away.z * n[2] > 0 ? 1 : -1;
    away = {above * n[0], above * n[1], above * n[2]};
  }
  const double move = level_.height - distance;
  const Vec3 c = cube.centre();
  point.position = {c.x + move * away.x, c.y + move * away.y, c.z + move * away.z};
  point.normal = {level_.side * away.x, level_.side * away.y, level_.side * away.z};
  point.triangle = base_triangle(number, place);
  point.error = error_;
  return move > 0 ? Outcome::moved_away : Outcome::point;
}

/// The value a hair beyond the point, which reaches the height by more than its own error, tells that the
/// contour passes in between.
void LeafDescent::check_moved(TileNumbers numbers, std::size_t count) {
  RegionPoints moved;
  moved.count = 0;
  std::array<std::size_t, RegionPoints::most> from;
  for (std::size_t i = 0; i < count; ++i) {
    if (outcomes_[i] != Outcome::moved_away) continue;
    ContourPoint& point = found_[i];
    point.error = 2 * error_;
    const double step = level_.side * 1.5 * error_;
    const Vec3 x{point.position.x + step * point.normal.x, point.position.y + step * point.normal.y,
                 point.position.z + step * point.normal.z};
    if (holds(region_, x)) {
      from[moved.count] = i;
      moved.add(x.x - middle_.x, x.y - middle_.y, x.z - middle_.z);
    } else {
      ++counts_.evaluations;
      const bool reached = std::fabs(signed_distance(field_, x)) >= level_.height + error_;
      outcomes_[i] = reached ? Outcome::point : Outcome::single;
    }
  }
  alignas(64) double squared[RegionPoints::most];
  if (numbers.size() > 1) {
    squared_distances(frames_, numbers, moved, squared);
    counts_.evaluations += moved.count;
  }
  for (std::size_t k = 0; k < moved.count; ++k) {
    const bool reached = numbers.size() == 1 || std::sqrt(squared[k]) >= level_.height + error_;
    outcomes_[from[k]] = reached ? Outcome::point : Outcome::single;
  }
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
    const bool shares =
        place == 0  ? std::is_permutation(own.vertices.begin(), own.vertices.end(), other.vertices.begin())
        : place < 4 ? among(own.edges[place - 1], other.edges)
                    : among(own.vertices[place - 4], other.vertices);
    const bool has_area = !(rounded(field_.triangles.shape(slot).normal) == Vec3{});
    if (shares && has_area) lowest = std::min(lowest, other.number);
  }
  return lowest;
}

}  // namespace cdfr
