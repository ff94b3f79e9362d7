#include "mesh/self_contact.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>

#include "core/parallel.h"
#include "geometry/box_distance.h"
#include "geometry/triangle_contact.h"

namespace cdfr {
namespace {

/// Groups that a task looks at, neighbours as a rule: a few milliseconds of work.
constexpr std::size_t chunk_size = 128;

std::uint32_t slot_of(std::size_t group, std::uint32_t lane) noexcept {
  return static_cast<std::uint32_t>(group * group_size) + lane;
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

/// The boxes of a group's triangles side by side: [axis][lane].
struct GroupBoxes {
  double lo[3][group_size], hi[3][group_size];

  void set(std::size_t lane, const Box& box) noexcept {
    lo[0][lane] = box.lo.x, lo[1][lane] = box.lo.y, lo[2][lane] = box.lo.z;
    hi[0][lane] = box.hi.x, hi[1][lane] = box.hi.y, hi[2][lane] = box.hi.z;
  }
  Box box(std::size_t lane) const noexcept {
    return {{lo[0][lane], lo[1][lane], lo[2][lane]}, {hi[0][lane], hi[1][lane], hi[2][lane]}};
  }
  /// One bit a lane: the triangle's box overlaps that box.
  unsigned overlapping(const Box& b) const noexcept {
    unsigned bits = 0;
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      const bool meets = (lo[0][lane] <= b.hi.x) & (hi[0][lane] >= b.lo.x) & (lo[1][lane] <= b.hi.y) &
                         (hi[1][lane] >= b.lo.y) & (lo[2][lane] <= b.hi.z) & (hi[2][lane] >= b.lo.z);
      bits |= unsigned{meets} << lane;
    }
    return bits;
  }
};

/// Lanes without a triangle overlap nothing.
Large<GroupBoxes> boxes_of(const TriangleStore& triangles, const Scratch* scratch) {
  Large<GroupBoxes> boxes(triangles.group_count(), scratch);
  for_chunks(boxes.size(), chunk_size, [&](std::size_t first, std::size_t end) {
    for (std::size_t g = first; g < end; ++g) {
      for (std::uint32_t lane = 0; lane < group_size; ++lane) {
        const std::uint32_t slot = slot_of(g, lane);
        constexpr double none = std::numeric_limits<double>::infinity();
        const Box empty{{none, none, none}, {-none, -none, -none}};
        boxes[g].set(lane, slot < triangles.size() ? box_of(triangles.shape(slot).vertices) : empty);
      }
    }
  });
  return boxes;
}

/// The triangles of one group after another, each against all others until it meets one. By slot; a task has
/// slots of its own.
class Search {
 public:
  Search(SearchSpace space, std::span<const GroupBoxes> boxes, std::span<std::uint8_t> contacts,
         std::size_t first_group) noexcept
      : space_(space), boxes_(boxes), contacts_(contacts), first_slot_(slot_of(first_group, 0)) {}

  void run(std::size_t group) {
    group_ = group;
    open_ = 0;
    Box box = boxes_[group].box(0);
    for (std::uint32_t lane = 0; lane < space_.triangles.lanes(static_cast<std::uint32_t>(group)); ++lane) {
      probes_[lane] = ContactProbe(triangle_at(space_.triangles, slot_of(group, lane)));
      box = united(box, boxes_[group].box(lane));
      if (probes_[lane].has_area()) open_ |= 1U << lane;
    }
    walk(
        space_.bvh, 0, [&](std::uint32_t index) { return overlap(box, space_.bvh.nodes[index].box); },
        [&](std::uint32_t index) {
          look_at(space_.bvh.nodes[index].first_group);
          return open_ != 0;
        });
  }

 private:
  void look_at(std::uint32_t other_group) {
    for (unsigned left = open_; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
      unsigned others = boxes_[other_group].overlapping(boxes_[group_].box(lane));
      for (; others != 0; others &= others - 1) {
        const auto other = slot_of(other_group, static_cast<std::uint32_t>(std::countr_zero(others)));
        if (!meets(lane, other)) continue;
        contacts_[slot_of(group_, lane)] = 1;
        open_ &= ~(1U << lane);
        break;
      }
    }
  }

  /// An earlier one of this task that met none has been tried on this one too, or has no area.
  bool meets(std::uint32_t lane, std::uint32_t other) const {
    const std::uint32_t own = slot_of(group_, lane);
    if (other == own || (other >= first_slot_ && other < own && contacts_[other] == 0)) return false;
    return probes_[lane].meets(triangle_at(space_.triangles, other));
  }

  SearchSpace space_;
  std::span<const GroupBoxes> boxes_;
  std::span<std::uint8_t> contacts_;
  std::uint32_t first_slot_;
  std::size_t group_ = 0;
  std::array<ContactProbe, group_size> probes_;
  unsigned open_ = 0;  ///< a bit for each triangle with an area that has met none so far
};

}  // namespace

Large<std::uint8_t> self_contacts(SearchSpace space, Progress& progress, const Scratch* scratch) {
  const Large<GroupBoxes> boxes = boxes_of(space.triangles, scratch);
  Large<std::uint8_t> contacts(space.triangles.size(), 0, scratch);
  for_chunks(boxes.size(), chunk_size, [&](std::size_t first, std::size_t end) {
    Search search(space, boxes, contacts, first);
    for (std::size_t group = first; group < end; ++group) {
      if (group % 16 == 0 && !progress.poll()) return;
      search.run(group);
    }
  });
  return contacts;
}

}  // namespace cdfr
