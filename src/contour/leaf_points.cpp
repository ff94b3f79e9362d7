#include "contour/leaf_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "field/batch.h"

namespace cdfr {
namespace {

/// How often a point is moved away from one sheet after another.
constexpr int most_rounds = 4;
/// Triangles of a list whose distances at the corners may show that the contour is not in the cube.
constexpr std::size_t most_tried = 16;

double largest_of(const Vec3& x) noexcept {
  return std::max({std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
}

}  // namespace

void LeafPoints::put(const RegionPoints& centres, const NearTriangles& near) {
  find_feet(near, centres, 0, feet_);
  counts_.evaluations += centres.count;
  const double most = level_.reach(Cube{{}, region_.final_size}.half_diagonal()) + region_.error;
  const bool is_alone = near.numbers.size() == 1;
  for (std::size_t i = 0; i < centres.count; ++i) {
    const double move = level_.height - feet_.distance[i];
    if (std::fabs(move) <= most) put_one(i, centres.point(i), move, is_alone);
  }
  check_moved(near);
  redo_failed();
}

/// False if the closest triangle has no area, or the distance tells no direction.
bool LeafPoints::has_way(std::size_t i) const noexcept {
  return triangles_.has_face(static_cast<std::size_t>(feet_.number[i])) && feet_.distance[i] > region_.error;
}

/// On the ray from the foot through that point.
Vec3 LeafPoints::moved_by(double length, std::size_t i, const Vec3& from) const noexcept {
  return {from.x + length * feet_.away[0][i], from.y + length * feet_.away[1][i],
          from.z + length * feet_.away[2][i]};
}

/// Of a point that is to move away from its foot by so much.
double LeafPoints::error_of(double move) const noexcept {
  const double error = region_.error;
  if (level_.rule == Rule::paper) return move > 0 ? std::numeric_limits<double>::infinity() : error - move;
  return move > 0 ? 2 * error : error;
}

/// The point at the height, written where it stays: a copy would wait for its parts.
void LeafPoints::set_point(ContourPoint& point, std::size_t i, const Vec3& from, double move) {
  const Vec3 x = level_.rule == Rule::paper ? from : moved_by(move, i, from);
  const double side = level_.side;
  point.position = {region_.middle.x + x.x, region_.middle.y + x.y, region_.middle.z + x.z};
  point.normal = {side * feet_.away[0][i], side * feet_.away[1][i], side * feet_.away[2][i]};
  point.triangle = triangles_.base_triangle(static_cast<std::size_t>(feet_.number[i]),
                                            static_cast<TrianglePlace>(feet_.place[i]));
  point.error = error_of(move);
}

bool LeafPoints::in_region(const Vec3& x) const noexcept { return largest_of(x) <= region_.cube.size / 2; }

void LeafPoints::put_one(std::size_t i, const Vec3& centre, double move, bool is_alone) {
  if (!has_way(i)) return failed_.push_back({centre, points_.size(), false});
  set_point(points_.emplace_back(), i, centre, move);
  if (move <= 0 || level_.rule == Rule::paper) return;
  const Vec3 beyond = moved_by(move + 1.5 * region_.error, i, centre);
  if (!in_region(beyond)) {
    beyond_.push_back({centre, points_.size() - 1, true});
  } else if (!is_alone) {
    moved_from_.push_back({centre, points_.size() - 1, true});
    moved_.add(beyond);
  }
}

/// A point that came too close to another sheet, moved away from that one: near an edge of the contour that
/// is often a point of it. False if that leads out of what the cube's list and tolerance cover.
bool LeafPoints::put_again(std::size_t i, const Placed& placed) {
  if (!has_way(i)) return false;
  const double move = level_.height - feet_.distance[i];
  const Vec3 beyond = moved_by(move + 1.5 * region_.error, i, again_.point(i));
  if (!in_region(beyond)) return false;
  const Vec3 off{beyond.x - placed.centre.x, beyond.y - placed.centre.y, beyond.z - placed.centre.z};
  const double half = level_.tolerance / 2;
  if (largest_of(off) > (0.5 + grown_by) * region_.final_size) return false;
  if (off.x * off.x + off.y * off.y + off.z * off.z > half * half) return false;
  set_point(points_[placed.point], i, again_.point(i), move);
  points_[placed.point].error = 2 * region_.error;
  moved_.add(beyond);
  moved_from_.push_back(placed);
  return true;
}

/// The value a hair beyond a point, which has to reach the height by more than its own error, tells that the
/// contour passes in between.
void LeafPoints::check_moved(const NearTriangles& near) {
  const double least = (level_.height + region_.error) * (1 + 4 * unit_roundoff);
  for (int round = 0; moved_.count > 0; ++round) {
    squared_distances(near, moved_, squared_.data(), least);
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
    if (round < most_rounds) find_feet(near, again_, 0, feet_);
    for (std::size_t i = 0; i < again_.count; ++i) {
      Placed& placed = again_from_[i];
      if (round < most_rounds && put_again(i, placed)) continue;
      placed.is_excluded = is_below(placed.centre, near);
      failed_.push_back(placed);
    }
  }
}

/// True if no point of the cube of final size around that centre is as far from the surface as the height:
/// distance_above's bound, for triangles of the list.
bool LeafPoints::is_below(const Vec3& centre, const NearTriangles& near) {
  const double half = region_.final_size / 2, height = level_.height - region_.error;
  corners_.count = 0;
  for (int corner = 0; corner < 8; ++corner) {
    corners_.add({centre.x + (corner & 1 ? half : -half), centre.y + (corner & 2 ? half : -half),
                  centre.z + (corner & 4 ? half : -half)});
  }
  const std::size_t count = std::min(near.numbers.size(), most_tried);
  std::array<std::array<double, 8>, most_tried> at;
  for (std::size_t k = 0; k < count; ++k) {
    squared_distances({near.frames, near.numbers.subspan(k, 1)}, corners_, squared_.data());
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

void LeafPoints::end() {
  if (beyond_.empty()) return;
  std::vector<Vec3> beyond;
  for (const Placed& placed : beyond_) {
    const ContourPoint& point = points_[placed.point];
    const double step = level_.side * 1.5 * region_.error;
    const Vec3 &x = point.position, &n = point.normal;
    beyond.push_back({x.x + step * n.x, x.y + step * n.y, x.z + step * n.z});
  }
  std::vector<double> distances(beyond.size());
  const Run silent;
  Progress progress(silent);
  answer(field_, Points(beyond), 0, std::span<double>(distances), progress);
  counts_.evaluations += beyond.size();
  for (std::size_t i = 0; i < beyond.size(); ++i) {
    if (!(std::fabs(distances[i]) >= level_.height + region_.error)) failed_.push_back(beyond_[i]);
  }
  beyond_.clear();
  redo_failed();
}

/// The general way for what failed, each point in its place.
void LeafPoints::redo_failed() {
  if (failed_.empty()) return;
  std::stable_sort(failed_.begin(), failed_.end(),
                   [](const Placed& a, const Placed& b) { return a.point < b.point; });
  const std::size_t first = failed_.front().point;
  before_.assign(points_.begin() + static_cast<std::ptrdiff_t>(first), points_.end());
  points_.resize(first);
  const double half = region_.final_size / 2;
  std::size_t next = 0;
  auto moved_out = std::find_if(beyond_.begin(), beyond_.end(),
                                [&](const Placed& placed) { return placed.point >= first; });
  const auto keep_until = [&](std::size_t end) {
    for (; moved_out != beyond_.end() && moved_out->point - first < end; ++moved_out)
      moved_out->point += points_.size() - next - first;
    points_.insert(points_.end(), before_.begin() + static_cast<std::ptrdiff_t>(next),
                   before_.begin() + static_cast<std::ptrdiff_t>(end));
  };
  for (const Placed& placed : failed_) {
    keep_until(placed.point - first);
    next = placed.point - first + (placed.is_there ? 1 : 0);
    const Vec3 &m = region_.middle, &c = placed.centre;
    const Vec3 lo{m.x + c.x - half, m.y + c.y - half, m.z + c.z - half};
    if (!placed.is_excluded) single_.finish({lo, region_.final_size});
  }
  keep_until(before_.size());
  failed_.clear();
}

}  // namespace cdfr
