#include "mesh/self_contact.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "core/parallel.h"
#include "geometry/box_distance.h"
#include "geometry/triangle_contact.h"

namespace cdfr {
namespace {

/// Groups a task looks at, neighbours as a rule: about a millisecond of work.
constexpr std::size_t chunk_size = 64;

std::uint32_t slot_of(std::uint32_t group, std::uint32_t lane) noexcept {
  return group * static_cast<std::uint32_t>(group_size) + lane;
}

ContactTriangle triangle_at(const TriangleStore& triangles, std::uint32_t slot) noexcept {
  const TriangleShape& shape = triangles.shape(slot);
  return {shape.vertices, triangles.records[slot].vertices, rounded(shape.normal)};
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

/// The triangles of one group, each against all others.
class Search {
 public:
  Search(SearchSpace space, std::uint32_t group, std::span<std::uint8_t> contacts) noexcept
      : space_(space), group_(group), contacts_(contacts) {
    for (std::uint32_t lane = 0; lane < space.triangles.lanes(group); ++lane) {
      const ContactTriangle triangle = triangle_at(space.triangles, slot_of(group, lane));
      probes_[lane] = ContactProbe(triangle);
      boxes_[lane] = box_of(triangle.corners);
      box_ = lane == 0 ? boxes_[0] : united(box_, boxes_[lane]);
      if (probes_[lane].has_area()) open_ |= 1U << lane;
    }
  }

  void run() {
    walk(
        space_.bvh, 0, [&](std::uint32_t index) { return overlap(box_, space_.bvh.nodes[index].box); },
        [&](std::uint32_t index) {
          look_at(space_.bvh.nodes[index].first_group);
          return open_ != 0;
        });
  }

 private:
  void look_at(std::uint32_t number) {
    const TriangleGroup group = space_.triangles.group(number);
    const unsigned all = (1U << space_.triangles.lanes(number)) - 1;
    for (unsigned left = open_; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
      if (meets_one_of(lane, number, overlapping_lanes(group, boxes_[lane]) & all)) open_ &= ~(1U << lane);
    }
  }

  bool meets_one_of(std::uint32_t lane, std::uint32_t number, unsigned lanes) {
    const std::uint32_t own = slot_of(group_, lane);
    for (; lanes != 0; lanes &= lanes - 1) {
      const std::uint32_t other = slot_of(number, static_cast<std::uint32_t>(std::countr_zero(lanes)));
      if (other == own || !probes_[lane].meets(triangle_at(space_.triangles, other))) continue;
      contacts_[own] = 1;
      return true;
    }
    return false;
  }

  SearchSpace space_;
  std::uint32_t group_;
  std::span<std::uint8_t> contacts_;
  std::array<ContactProbe, group_size> probes_;
  std::array<Box, group_size> boxes_;
  Box box_;
  unsigned open_ = 0;  ///< a bit for each triangle with an area that has met none so far
};

}  // namespace

std::vector<std::uint8_t> self_contacts(SearchSpace space, Progress& progress) {
  std::vector<std::uint8_t> contacts(space.triangles.size(), 0);
  for_chunks(space.triangles.group_count(), chunk_size, [&](std::size_t first, std::size_t end) {
    if (!progress.poll()) return;
    for (std::size_t group = first; group < end; ++group)
      Search(space, static_cast<std::uint32_t>(group), contacts).run();
  });
  return contacts;
}

}  // namespace cdfr
