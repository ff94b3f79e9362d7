#include "mesh/self_contact.h"

#include <algorithm>
#include <array>

#include "core/parallel.h"
#include "geometry/box_distance.h"
#include "geometry/triangle_contact.h"

namespace cdfr {
namespace {

/// About a millisecond of work.
constexpr std::size_t chunk_size = 512;

ContactTriangle triangle_at(const TriangleStore& triangles, std::uint32_t slot) noexcept {
  return {triangles.shape(slot).vertices, triangles.records[slot].vertices};
}

Box box_of(const std::array<Vec3, 3>& t) noexcept {
  const auto least = [&](double Vec3::*c) { return std::min({t[0].*c, t[1].*c, t[2].*c}); };
  const auto most = [&](double Vec3::*c) { return std::max({t[0].*c, t[1].*c, t[2].*c}); };
  return {{least(&Vec3::x), least(&Vec3::y), least(&Vec3::z)},
          {most(&Vec3::x), most(&Vec3::y), most(&Vec3::z)}};
}

/// One bit a lane: the triangle's box overlaps that box.
unsigned overlapping_lanes(const TriangleGroup& group, const Box& box) noexcept {
  const double lo[3] = {box.lo.x, box.lo.y, box.lo.z};
  const double hi[3] = {box.hi.x, box.hi.y, box.hi.z};
  bool meets[group_size];
  std::fill_n(meets, group_size, true);
  for (int axis = 0; axis < 3; ++axis) {
    const auto &a = group.vertices[0][axis], &b = group.vertices[1][axis], &c = group.vertices[2][axis];
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      const double least = std::min(std::min(a[lane], b[lane]), c[lane]);
      const double most = std::max(std::max(a[lane], b[lane]), c[lane]);
      meets[lane] = meets[lane] & (least <= hi[axis]) & (most >= lo[axis]);
    }
  }
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < group_size; ++lane) bits |= unsigned{meets[lane]} << lane;
  return bits;
}

class Search {
 public:
  Search(SearchSpace space, std::uint32_t slot) noexcept
      : space_(space), slot_(slot), triangle_(triangle_at(space.triangles, slot)), probe_(triangle_) {}

  bool finds_contact() const noexcept {
    if (!probe_.has_area()) return false;
    const Box box = box_of(triangle_.corners);
    const std::vector<BvhNode>& nodes = space_.bvh.nodes;
    return !walk(
        space_.bvh, 0, [&](std::uint32_t index) { return overlap(box, nodes[index].box); },
        [&](std::uint32_t index) { return !meets_one_of(nodes[index].first_group, box); });
  }

 private:
  bool meets_one_of(std::uint32_t number, const Box& box) const noexcept {
    unsigned lanes = overlapping_lanes(space_.triangles.group(number), box);
    lanes &= (1U << space_.triangles.lanes(number)) - 1;
    for (std::uint32_t other = number * group_size; lanes != 0; lanes >>= 1, ++other) {
      if ((lanes & 1) == 0 || other == slot_) continue;
      if (probe_.meets(triangle_at(space_.triangles, other))) return true;
    }
    return false;
  }

  SearchSpace space_;
  std::uint32_t slot_;
  ContactTriangle triangle_;
  ContactProbe probe_;
};

}  // namespace

std::vector<std::uint8_t> self_contacts(SearchSpace space, Progress& progress) {
  std::vector<std::uint8_t> contacts(space.triangles.size(), 0);
  for_chunks(contacts.size(), chunk_size, [&](std::size_t first, std::size_t end) {
    if (!progress.poll()) return;
    for (std::size_t slot = first; slot < end; ++slot) {
      contacts[slot] = Search(space, static_cast<std::uint32_t>(slot)).finds_contact() ? 1 : 0;
    }
  });
  return contacts;
}

}  // namespace cdfr
