#include "field/leaf_winding.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "field/boundary.h"
#include "field/field_data.h"
#include "field/leaves.h"
#include "field/side.h"
#include "field/winding.h"
#include "geometry/angle_sum.h"
#include "geometry/box_distance.h"
#include "geometry/offset.h"
#include "geometry/segment_crossings.h"
#include "mesh/crossings.h"

namespace cdfr {
namespace {

/// From a leaf's centre to its reference point, in sizes of the leaf: in general position, so that faces in
/// planes of the lattice do not hold it.
constexpr Vec3 off_centre{0.0713, -0.0457, 0.0291};
constexpr double from_centre = 0.09;  ///< its length, rounded up
/// No point of a leaf is farther from its reference point, in sizes of the leaf: half the diagonal, and that.
constexpr double reach = 0.96;

/// More near edges take as long as the winding number itself.
constexpr std::size_t most_edges = 128;
/// What may be left open of the change by the boundary: most places are farther from w = 1/2.
constexpr double most_drift = 0x1p-2;
/// Of w(r), where that is not whole.
constexpr double good_error = 0x1p-7;
/// Covers the rounding of w(r), gradient and drift to single precision and of sums. As that is more than
/// winds() may be mistaken by, who asks that gets the same answer.
constexpr double rounding = 0x1p-16;

struct Reference {
  Vec3 at;
  double radius;  ///< of a ball around it that holds the leaf
};

Reference reference_of(const Lattice& lattice, const Cell& cell) noexcept {
  const double size = lattice.size(cell.level);
  const Vec3 c = lattice.centre(cell);
  return {{c.x + off_centre.x * size, c.y + off_centre.y * size, c.z + off_centre.z * size},
          reach * size + 2 * lattice.grown()};
}

/// What a block's leaves come to know.
class BlockWindings {
 public:
  explicit BlockWindings(const FieldData& field) : field_(field), block_(field.tree.block(0)) {
    for_each_leaf(block_, [&](const Cell& cell, std::uint32_t leaf) {
      const Side side = block_.leaves[leaf].side();
      const bool is_needed = side == Side::surface || side == Side::undecided;
      const Reference r = reference_of(field_.tree.lattice, cell);
      if (field_.winding.empty()) {
        all_.whole.push_back(is_needed ? winding_at(r.at) : LeafWindings::unknown);
      } else {
        all_.place.push_back(is_needed && is_found(r) ? static_cast<std::uint32_t>(all_.known.size() - 1)
                                                      : no_index);
      }
    });
  }

  LeafWindingLists take() { return std::move(all_); }

 private:
  std::int32_t winding_at(const Vec3& p) const noexcept {
    if (const std::optional<int> winding = winding_by_closest(field_, p)) return *winding;
    return winding_by_crossings(p, field_.space());
  }

  bool is_found(const Reference& r) {
    const std::optional<BoundaryPart> part =
        boundary_around(field_.winding.boundary, field_.space(), r.at, r.radius, most_drift, most_edges);
    if (!part) return false;
    const Bounded w = winding_within(field_.winding, field_.space(), r.at, good_error);
    if (!(w.error <= good_error)) return false;
    const auto single = [](double x) { return static_cast<float>(x); };
    const Vec3& g = part->gradient;
    const double unit = r.radius;
    all_.known.push_back({single(w.value),
                          {single(g.x * unit), single(g.y * unit), single(g.z * unit)},
                          single(part->drift),
                          static_cast<std::uint32_t>(all_.near.size())});
    all_.near.insert(all_.near.end(), part->near.begin(), part->near.end());
    return true;
  }

  const FieldData& field_;
  Block block_;
  LeafWindingLists all_;
};

/// Triangles of the list that may meet the segment. False if one of them leaves it open. No point of the
/// segment is farther from the leaf's centre than `farthest` edges.
bool count_crossings(const FieldData& field, std::span<const Entry> list, double farthest, const Box& box,
                     SegmentCrossings& crossings) noexcept {
  const SearchSpace space = field.space();
  const auto add = [&](std::uint32_t group, unsigned lanes) {
    const unsigned own = space.triangles.own_lanes(group);
    return crossings.add(space.triangles.group(group), lanes & own);
  };
  for (const Entry& entry : list) {
    if (entry.distance() > farthest) break;
    if (entry.is_group()) {
      if (!add(entry.number(), entry.lanes())) return false;
      continue;
    }
    const auto enter = [&](std::uint32_t node) { return overlap(space.bvh.nodes[node].box, box); };
    const auto group = [&](std::uint32_t node) { return add(space.bvh.nodes[node].first_group, 0xff); };
    if (!walk(space.bvh, entry.number(), enter, group)) return false;
  }
  return true;
}

/// What the boundary changes on the way from r to p.
Bounded changed(const FieldData& field, const LeafWindings::Known* known, const Vec3& p,
                const Reference& r) noexcept {
  AngleSum swept;
  for (std::uint32_t i = known[0].first; i < known[1].first; ++i) {
    const BoundaryEdge& edge = field.winding.boundary.edges[field.leaf_windings.near[i]];
    for (double k = 0; k < edge.times; ++k) swept.add_swept(p, r.at, edge.from, edge.to);
  }
  const Bounded angle = swept.sum();
  const Vec3 way = minus(p, r.at);
  const float* g = known->gradient;
  return {angle.value / four_pi + (g[0] * way.x + g[1] * way.y + g[2] * way.z) / r.radius,
          angle.error / four_pi + known->drift * (distance_between(p, r.at) / r.radius)};
}

/// A point in its leaf.
struct Place {
  LatticePoint point;
  std::uint32_t leaf;
  Cell cell;
};

Place place_of(const LeafIndex& index, const Vec3& p) noexcept {
  const LatticePoint point = index.place(p);
  const std::uint32_t leaf = index.leaf(point), up = index.up(leaf);
  return {point,
          leaf,
          {deepest_level - static_cast<int>(up),
           {point.place[0] >> up, point.place[1] >> up, point.place[2] >> up}}};
}

/// Passages on the way from p to r; nothing if that is open.
std::optional<int> crossings_to(const FieldData& field, const Place& place, const Vec3& p,
                                const Vec3& r) noexcept {
  const Located located = field.index.at(place.point, place.leaf);
  const double farthest = std::max(located.from_centre, from_centre * std::ldexp(1.0, -place.cell.level));
  SegmentCrossings crossings(p, r);
  const bool is_certain =
      count_crossings(field, located.entries, farthest, united({p, p}, {r, r}), crossings);
  return is_certain ? std::optional(crossings.total()) : std::nullopt;
}

int side_if_whole(const FieldData& field, const Place& place, const Vec3& p) noexcept {
  const std::int32_t at_reference = field.leaf_windings.whole[place.leaf];
  if (at_reference == LeafWindings::unknown) return 0;
  const std::optional<int> crossings =
      crossings_to(field, place, p, reference_of(field.tree.lattice, place.cell).at);
  if (!crossings) return 0;
  return at_reference + *crossings > 0 ? -1 : 1;
}

int side_with_boundary(const FieldData& field, const Place& place, const Vec3& p) noexcept {
  const std::uint32_t number = field.leaf_windings.place[place.leaf];
  if (number == no_index) return 0;
  const LeafWindings::Known* known = &field.leaf_windings.known[number];
  const Reference r = reference_of(field.tree.lattice, place.cell);
  const std::optional<int> crossings = crossings_to(field, place, p, r.at);
  if (!crossings) return 0;
  const Bounded change = changed(field, known, p, r);
  const double above = static_cast<double>(known->at_reference) + *crossings + change.value - 0.5;
  if (!(std::fabs(above) > change.error + good_error + rounding)) return 0;
  return above > 0 ? -1 : 1;
}

}  // namespace

std::uint64_t LeafWindings::bytes() const noexcept {
  return whole.bytes() + known.bytes() + place.bytes() + near.bytes();
}

LeafWindingLists block_windings(const FieldData& field) {
  if (field.sign != Sign::winding) return {};
  return BlockWindings(field).take();
}

void move_behind(LeafWindingLists& part, std::uint64_t known, std::uint64_t near) noexcept {
  for (std::uint32_t& place : part.place) {
    if (place != no_index) place += static_cast<std::uint32_t>(known);
  }
  for (LeafWindings::Known& k : part.known) k.first += static_cast<std::uint32_t>(near);
}

LeafWindings leaf_windings(LeafWindingLists all) {
  if (!all.place.empty()) all.known.push_back({0, {}, 0, static_cast<std::uint32_t>(all.near.size())});
  return {std::move(all.whole), std::move(all.place), std::move(all.known), std::move(all.near)};
}

int side_by_leaf(const FieldData& field, const Vec3& p) noexcept {
  const LeafWindings& all = field.leaf_windings;
  if ((all.whole.empty() && all.place.empty()) || !field.index.contains(p)) return 0;
  const Place place = place_of(field.index, p);
  return all.place.empty() ? side_if_whole(field, place, p) : side_with_boundary(field, place, p);
}

}  // namespace cdfr
