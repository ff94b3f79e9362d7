#include "contour/leaf_triangles.h"

#include <algorithm>
#include <bit>

namespace cdfr {
namespace {

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

bool LeafTriangles::fill(std::span<const Entry> list, const Vec3& middle, double radius) {
  slots_.clear();
  for (const Entry& entry : list) {
    if (!entry.is_group()) return false;
    for (unsigned lanes = entry.lanes(); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      slots_.push_back(entry.number() * static_cast<std::uint32_t>(group_size) + lane);
    }
    if (slots_.size() > most) return false;
  }
  frames_.clear();
  has_face_.clear();
  error_ = 0;
  for (const std::uint32_t slot : slots_) {
    const TriangleShape& shape = triangles_.shape(slot);
    frames_.push_back(triangle_frame(shape, middle, radius));
    has_face_.push_back(rounded(shape.normal) == Vec3{} ? 0 : 1);
    error_ = std::max(error_, frames_.back().error);
  }
  std::array<std::uint32_t, 7> none;
  none.fill(not_asked);
  base_.assign(slots_.size(), none);
  return true;
}

/// Those are equally close, and all of them are in the list.
std::uint32_t LeafTriangles::lowest_at(std::size_t number, TrianglePlace place) const noexcept {
  const TriangleRecord& own = triangles_.records[slots_[number]];
  std::uint32_t lowest = own.number;
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    const TriangleRecord& other = triangles_.records[slots_[k]];
    if (other.number < lowest && shares(own, other, place) && has_face(k)) lowest = other.number;
  }
  return lowest;
}

}  // namespace cdfr
