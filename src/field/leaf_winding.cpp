#include "field/leaf_winding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "field/boundary.h"
#include "field/field_data.h"
#include "field/leaves.h"
#include "field/winding.h"
#include "geometry/angle_sum.h"
#include "geometry/box_distance.h"
#include "geometry/offset.h"
#include "geometry/segment_crossings.h"
#include "mesh/crossings.h"

namespace cdfr {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/// From a leaf's centre to its reference point, in sizes of the leaf: in general position, so that faces in
/// planes of the lattice do not hold it.
constexpr Vec3 off_centre{0.0713, -0.0457, 0.0291};
constexpr double from_centre = 0.09;  ///< its length, rounded up
/// No point of a leaf is farther from its reference point, in sizes of the leaf: half the diagonal, and that.
constexpr double reach = 0.96;

/// More near edges take as long as the winding number itself.
constexpr std::size_t most_edges = 64;
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
  BlockWindings(const FieldData& field, std::size_t block) : field_(field), block_(field.tree.blocks[block]) {
    const std::size_t count = block_.leaves.size();
    all_.at_reference.assign(count, unknown);
    for_each_leaf(block_, [&](const Cell& cell, std::uint32_t leaf) {
      if (!field_.winding.empty()) all_.changes.push_back({{}, 0, static_cast<std::uint32_t>(all_.near.size())});
      const Side side = block_.leaves[leaf].side();
      if (side == Side::surface || side == Side::undecided) find(reference_of(field_.tree.lattice, cell), leaf);
    });
  }

  LeafWindings take() { return std::move(all_); }

 private:
  void find(const Reference& r, std::uint32_t leaf) {
    if (field_.winding.empty()) {
      all_.at_reference[leaf] = static_cast<float>(winding_by_crossings(r.at, field_.space()));
    } else {
      find_between(r, leaf);
    }
  }

  void find_between(const Reference& r, std::uint32_t leaf) {
    const std::optional<BoundaryPart> part = boundary_around(field_.winding.boundary, field_.space(), r.at,
                                                             r.radius, most_drift, most_edges);
    if (!part) return;
    const Bounded w = winding_within(field_.winding, field_.space(), r.at, good_error);
    if (!(w.error <= good_error)) return;
    all_.at_reference[leaf] = static_cast<float>(w.value);
    LeafWindings::Change& change = all_.changes.back();
    const Vec3& g = part->gradient;
    change = {{static_cast<float>(g.x), static_cast<float>(g.y), static_cast<float>(g.z)},
              static_cast<float>(part->drift), change.first};
    all_.near.insert(all_.near.end(), part->near.begin(), part->near.end());
  }

  const FieldData& field_;
  const Block& block_;
  LeafWindings all_;
};

void append(LeafWindings& all, const LeafWindings& part) {
  const auto before = static_cast<std::uint32_t>(all.near.size());
  all.at_reference.insert(all.at_reference.end(), part.at_reference.begin(), part.at_reference.end());
  for (LeafWindings::Change change : part.changes) {
    change.first += before;
    all.changes.push_back(change);
  }
  all.near.insert(all.near.end(), part.near.begin(), part.near.end());
}

/// Triangles of the list that may meet the segment. False if one of them leaves it open. No point of the
/// segment is farther from the leaf's centre than `farthest` edges.
bool count_crossings(const FieldData& field, std::span<const Entry> list, double farthest, const Box& box,
                     SegmentCrossings& crossings) noexcept {
  const SearchSpace space = field.space();
  const auto add = [&](std::uint32_t group, unsigned lanes) {
    const unsigned own = (1U << space.triangles.lanes(group)) - 1;
    return crossings.add(space.triangles.groups[group], lanes & own);
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
Bounded changed(const FieldData& field, std::uint32_t leaf, const Vec3& p, const Reference& r) noexcept {
  const LeafWindings::Change* change = &field.leaf_windings.changes[leaf];
  AngleSum swept;
  for (std::uint32_t i = change[0].first; i < change[1].first; ++i) {
    const BoundaryEdge& edge = field.winding.boundary.edges[field.leaf_windings.near[i]];
    for (double k = 0; k < edge.times; ++k) swept.add_swept(p, r.at, edge.from, edge.to);
  }
  const Bounded angle = swept.sum();
  const Vec3 way = minus(p, r.at);
  const float* g = change->gradient;
  return {angle.value / four_pi + g[0] * way.x + g[1] * way.y + g[2] * way.z,
          angle.error / four_pi + change->drift * (distance_between(p, r.at) / r.radius)};
}

}  // namespace

std::uint64_t LeafWindings::bytes() const noexcept {
  return at_reference.capacity() * sizeof(float) + changes.capacity() * sizeof(Change) +
         near.capacity() * sizeof(std::uint32_t);
}

LeafWindings leaf_windings(const FieldData& field) {
  LeafWindings all;
  if (field.sign != Sign::winding) return all;
  std::vector<LeafWindings> parts(field.tree.blocks.size());
  for_chunks(parts.size(), 1,
             [&](std::size_t block, std::size_t) { parts[block] = BlockWindings(field, block).take(); });
  for (const LeafWindings& part : parts) append(all, part);
  if (!field.winding.empty()) all.changes.push_back({{}, 0, static_cast<std::uint32_t>(all.near.size())});
  return all;
}

int side_by_leaf(const FieldData& field, const Vec3& p) noexcept {
  const LeafWindings& all = field.leaf_windings;
  if (all.at_reference.empty() || !field.index.contains(p)) return 0;
  const LatticePoint point = field.index.place(p);
  const std::uint32_t leaf = field.index.leaf(point), up = field.index.up(leaf);
  if (std::isnan(all.at_reference[leaf])) return 0;
  const Cell cell{deepest_level - static_cast<int>(up),
                  {point.place[0] >> up, point.place[1] >> up, point.place[2] >> up}};
  const Reference r = reference_of(field.tree.lattice, cell);
  const Located located = field.index.at(point, leaf);
  const double farthest = std::max(located.from_centre, from_centre * std::ldexp(1.0, -cell.level));
  SegmentCrossings crossings(p, r.at);
  if (!count_crossings(field, located.entries, farthest, united({p, p}, {r.at, r.at}), crossings)) return 0;
  const double w = static_cast<double>(all.at_reference[leaf]) + crossings.total();
  if (all.changes.empty()) return w > 0.5 ? -1 : 1;
  const Bounded change = changed(field, leaf, p, r);
  const double above = w + change.value - 0.5;
  if (!(std::fabs(above) > change.error + good_error + rounding)) return 0;
  return above > 0 ? -1 : 1;
}

}  // namespace cdfr
