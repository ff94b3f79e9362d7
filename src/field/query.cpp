#include "field/query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/floating_environment.h"
#include "core/vector.h"
#include "field/side.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"
#include "octree/scan.h"
#include "octree/search.h"

namespace cdfr {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// What a search accepts, until the least estimate is known; then only the few that it does not rule out meet
/// the kernel. Where very many are equally close (the centre of a sphere) the kernel is asked in between.
class Contenders {
 public:
  Contenders(const Vec3& p, const FieldData& field) noexcept : race_(p, field.triangles, size_of(field, p)) {}

  void operator()(std::uint32_t slot, double squared, double reject) noexcept {
    if (size_ == held_.size()) {
      thin(reject);
      if (size_ == held_.size()) settle(reject);
    }
    held_[size_++] = {slot, squared};
  }

  Finding settle(double reject) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (held_[i].squared <= reject) race_.challenge(held_[i].slot);
    }
    size_ = 0;
    return race_.finding();
  }

 private:
  struct Held {
    std::uint32_t slot;
    double squared;
  };

  void thin(double reject) noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (held_[i].squared <= reject) held_[kept++] = held_[i];
    }
    size_ = kept;
  }

  Race race_;
  std::array<Held, 64> held_;
  std::size_t size_ = 0;
};

Finding closest_of(const FieldData& field, const Vec3& p, const Candidates& candidates) noexcept {
  Race race(p, field.triangles, size_of(field, p));
  for (std::uint32_t i = 0; i < candidates.count; ++i) race.challenge(candidates.slots[i]);
  return race.finding();
}

/// What an unfinished scan has found bounds the search from the start: the surface is that close.
Search<Contenders> search_from(const FieldData& field, const Vec3& p, double reach,
                               const Candidates& candidates) noexcept {
  Search search(field.space(), p, reach, Contenders(p, field));
  const double upper = double{candidates.upper} * field.tree.lattice.edge;
  search.bound(upper * upper);
  return search;
}

/// Bound on the distance from p to any point of the box.
double reach_of(const Box& box, const Vec3& p) noexcept {
  return (distance_between(p, box.lo) + diagonal_above(box)) * (1 + 8 * unit_roundoff);
}

double signed_by(const FieldData& field, const Query& query, const Finding& finding, int& side) noexcept {
  side = side_of(field, query.p, finding);
  const double distance = square_root(finding.winner.foot.squared) * query.scale;
  return side < 0 ? -distance : distance;
}

/// p minus the offset, held to the triangle's box: from 2^40 times the mesh's size on, the offset's own
/// rounding exceeds an ulp of the mesh.
Vec3 foot_point(const Query& query, const Winner& winner, const TriangleShape& shape) noexcept {
  const auto& v = shape.vertices;
  if (winner.foot.place >= 4) return v[winner.foot.place - 4];
  const auto held = [](double p, DoubleDouble offset, double a, double b, double c) {
    const double q = (DoubleDouble{p, 0} - offset).hi;
    return std::clamp(q, std::min({a, b, c}), std::max({a, b, c}));
  };
  const DoubleDouble3& o = winner.foot.offset;
  return {held(query.p.x, o[0], v[0].x, v[1].x, v[2].x), held(query.p.y, o[1], v[0].y, v[1].y, v[2].y),
          held(query.p.z, o[2], v[0].z, v[1].z, v[2].z)};
}

Eigen::Vector3d unit(Eigen::Vector3d v) noexcept {
  const double largest = v.lpNorm<Eigen::Infinity>();
  if (!(largest > 0)) return v;
  v /= largest;
  return v / v.norm();
}

/// The (pseudo)normal where the foot lies; where that is undecided or absent, the triangle's; z for a mesh
/// without any.
Eigen::Vector3d surface_normal(const FieldData& field, const Winner& winner,
                               const TriangleShape& shape) noexcept {
  const TriangleRecord& record = field.triangles.records[winner.slot];
  Eigen::Vector3d n = to_eigen(rounded(shape.normal));
  const TrianglePlace place = winner.foot.place;
  const bool has_own = field.sign != Sign::none && place != 0;
  const Vec3 own = has_own ? field.pseudonormals.at(place, record) : Vec3{};
  if (!(own == Vec3{})) n = unit(to_eigen(own));
  return n.isZero(0) ? Eigen::Vector3d::UnitZ() : n;
}

Vec3 gradient_of(const FieldData& field, const Winner& winner, const TriangleShape& shape,
                 int side) noexcept {
  if (winner.foot.squared.hi == 0) return from_eigen(surface_normal(field, winner, shape));
  const double sign = side < 0 ? -1 : 1;
  if (winner.foot.place == 0) {
    const double above = winner.foot.along.hi > 0 ? 1 : -1;
    return from_eigen(to_eigen(rounded(shape.normal)) * (above * sign));
  }
  return from_eigen(unit(to_eigen(rounded(winner.foot.offset))) * sign);
}

}  // namespace

/// A query beyond largest_query is drawn in by a power of two: all of the mesh is equally close to it to far
/// less than an ulp. Dust counts where the mesh is the origin alone, which looks the same at any size.
Query admitted(const FieldData& field, const Vec3& x) noexcept {
  const double size = largest_magnitude(x);
  const bool is_origin = field.bounds() == Box{};
  const bool tiny = is_origin && size < smallest_coordinate && size > 0;
  if (!(size > largest_query) && !tiny) return {without_dust(x), 1};
  const int excess = tiny ? std::ilogb(size) : std::ilogb(size) - std::ilogb(largest_query) + 1;
  const Vec3 near{std::ldexp(x.x, -excess), std::ldexp(x.y, -excess), std::ldexp(x.z, -excess)};
  return {without_dust(near), std::ldexp(1.0, excess)};
}

double size_of(const FieldData& field, const Vec3& p) noexcept {
  return std::max(
      {largest_magnitude(p), largest_magnitude(field.bounds().lo), largest_magnitude(field.bounds().hi)});
}

Finding closest_in_leaf(const FieldData& field, const Vec3& p, const Located& leaf,
                        const Candidates& candidates) noexcept {
  Finding finding;
  if (candidates.complete) {
    finding = closest_of(field, p, candidates);
  } else {
    const Lattice& lattice = field.tree.lattice;
    Search search = search_from(field, p, lattice.reach(), candidates);
    search.list(leaf.entries, lattice.edge, leaf.from_centre * lattice.edge);
    finding = search.accept().settle(search.reject());
  }
  finding.leaf = leaf.side;
  return finding;
}

Finding find_closest(const FieldData& field, const Vec3& p) noexcept {
  if (field.index.contains(p)) {
    const LatticePoint point = field.index.place(p);
    const Located leaf = field.index.at(point, field.index.leaf(point));
    Shortlist shortlist;
    shorten(field.scan_groups.data(), leaf, shortlist);
    Candidates candidates;
    scan(field.scan_space(), p, point.at, leaf, shortlist, candidates);
    return closest_in_leaf(field, p, leaf, candidates);
  }
  Candidates candidates;
  scan(field.scan_space(), p, candidates);
  if (candidates.complete) return closest_of(field, p, candidates);
  Search search = search_from(field, p, reach_of(field.bounds(), p), candidates);
  search.descend(0);
  return search.accept().settle(search.reject());
}

/// Two scans: the closest vertex bounds the distance, and only triangles whose box is within that bound meet
/// the kernel. The kernel is within 2^-93 of the reach and Race tells features apart by 2^-88 of the largest
/// coordinate, which is at most |p| + reach: what lies farther by 2^-80 of that has lost.
Finding find_closest_brute(const FieldData& field, const Vec3& p) noexcept {
  const TriangleStore& triangles = field.triangles;
  const auto corner = [&](std::uint32_t slot, std::size_t k) { return triangles.shape(slot).vertices[k]; };
  double radius = std::numeric_limits<double>::infinity();
  for (std::uint32_t slot = 0; slot < triangles.size(); ++slot) {
    for (std::size_t k = 0; k < 3; ++k) radius = std::min(radius, distance_between(p, corner(slot, k)));
  }
  radius = radius * (1 + 8 * unit_roundoff) + 0x1p-80 * (largest_magnitude(p) + reach_of(field.bounds(), p));
  const double reject = radius * radius * (1 + 4 * unit_roundoff);
  Race race(p, triangles, size_of(field, p));
  for (std::uint32_t slot = 0; slot < triangles.size(); ++slot) {
    const Vec3 a = corner(slot, 0), b = corner(slot, 1), c = corner(slot, 2);
    if (squared_distance_below(p, united(united({a, a}, {b, b}), {c, c})) <= reject) race.challenge(slot);
  }
  return race.finding();
}

std::optional<double> signed_by_leaf(const FieldData& field, Side side, double distance) noexcept {
  if (field.sign == Sign::none || distance == 0 || side == Side::outside) return distance;
  if (side == Side::inside) return -distance;
  return std::nullopt;
}

double signed_distance(const FieldData& field, const Query& query, const Finding& finding) noexcept {
  int side = 1;
  return signed_by(field, query, finding, side);
}

double signed_distance(const FieldData& field, const Vec3& x) noexcept {
  if (!is_finite(x)) return not_a_number;
  const FloatingEnvironment environment;
  const Query query = admitted(field, x);
  return signed_distance(field, query, find_closest(field, query.p));
}

double unsigned_distance(const FieldData& field, const Vec3& x) noexcept {
  if (!is_finite(x)) return not_a_number;
  const FloatingEnvironment environment;
  const Query query = admitted(field, x);
  return square_root(find_closest(field, query.p).winner.foot.squared) * query.scale;
}

Closest closest_point(const FieldData& field, const Query& query, const Finding& finding) noexcept {
  Closest result;
  const Winner& winner = finding.winner;
  const TriangleShape& shape = field.triangles.shape(winner.slot);
  int side = 1;
  result.distance = signed_by(field, query, finding, side);
  result.point = foot_point(query, winner, shape);
  result.gradient = gradient_of(field, winner, shape, side);
  result.triangle = winner.number;
  result.patch = field.triangles.exact[winner.slot].patch;
  const TrianglePlace place = winner.foot.place;
  result.feature = place == 0 ? Feature::face : (place < 4 ? Feature::edge : Feature::vertex);
  result.element = static_cast<std::uint8_t>(place == 0 ? 0 : (place - 1) % 3);
  result.barycentric = barycentric(query.p, shape, winner.foot);
  return result;
}

Closest closest_point(const FieldData& field, const Vec3& x, Finder finder) noexcept {
  if (!is_finite(x)) {
    Closest nowhere;
    nowhere.distance = not_a_number;
    nowhere.point = nowhere.gradient = {not_a_number, not_a_number, not_a_number};
    nowhere.barycentric = {not_a_number, not_a_number, not_a_number};
    return nowhere;
  }
  const FloatingEnvironment environment;
  const Query query = admitted(field, x);
  return closest_point(
      field, query,
      finder == Finder::tree ? find_closest(field, query.p) : find_closest_brute(field, query.p));
}

}  // namespace cdfr
