/// The triangles of a leaf's list, as seen from the middle of a region of it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "field/field_data.h"
#include "geometry/feet.h"
#include "geometry/place_estimate.h"
#include "geometry/supports.h"

namespace cdfr {

class LeafTriangles {
 public:
  static constexpr std::size_t most = Supports::most_numbers;

  explicit LeafTriangles(const FieldData& field) : triangles_(field.triangles) {}

  /// False if the list holds BVH nodes or more triangles than that. Points are `radius` from the middle at
  /// most.
  bool fill(std::span<const Entry> list, const Vec3& middle, double radius);
  std::span<const TriangleFrame> frames() const noexcept { return frames_; }
  /// The largest of TriangleFrame::error.
  double error() const noexcept { return error_; }
  bool has_face(std::size_t number) const noexcept { return has_face_[number] != 0; }
  /// The number in the input of the lowest of the triangles that share the feature at that place.
  std::uint32_t base_triangle(std::size_t number, TrianglePlace place) {
    std::uint32_t& base = base_[number][place];
    if (base == not_asked) base = lowest_at(number, place);
    return base;
  }

 private:
  static constexpr std::uint32_t not_asked = no_index;
  std::uint32_t lowest_at(std::size_t number, TrianglePlace place) const noexcept;

  const TriangleStore& triangles_;
  std::vector<std::uint32_t> slots_;
  std::vector<TriangleFrame> frames_;
  std::vector<std::uint8_t> has_face_;
  std::vector<std::array<std::uint32_t, 7>> base_;  ///< by number and place, as far as asked for
  double error_ = 0;
};

}  // namespace cdfr
