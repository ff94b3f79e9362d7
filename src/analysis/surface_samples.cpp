#include "analysis/surface_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/arithmetic.h"
#include "core/vector.h"

namespace cdfr {
namespace {

using Eigen::Vector3d;

constexpr double most_samples = 4294967294;

bool has_area(const TriangleShape& shape) noexcept { return rounded(shape.normal) != Vec3{}; }

SurfaceSample centre_of(const TriangleShape& shape, std::uint32_t slot) noexcept {
  const auto& [a, b, c] = shape.vertices;
  return {from_eigen((to_eigen(a) + to_eigen(b) + to_eigen(c)) / 3), rounded(shape.normal), slot,
          area_of(shape)};
}

/// A triangle cut into rows along its longest side.
class Rows {
 public:
  Rows(const TriangleShape& shape, std::uint32_t slot, double spacing) : shape_(shape), slot_(slot) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = (corner(k + 1) - corner(k)).norm();
      if (length > base_) {
        base_ = length;
        first_ = k;
      }
    }
    spacing_ = spacing;
    rows_ = std::max(1.0, std::ceil(2 * area_of(shape) / base_ / spacing));
  }

  double rows() const noexcept { return rows_; }
  double upper_count() const noexcept { return rows_ * (base_ / spacing_ + 1); }

  void append(std::vector<SurfaceSample>& samples) const {
    const Vector3d origin = corner(first_), along = corner(first_ + 1) - origin,
                   up = corner(first_ + 2) - origin;
    const double area = area_of(shape_);
    for (double row = 0; row < rows_; ++row) {
      const double height = (row + 0.5) / rows_, width = 1 - height;
      const double parts = std::max(1.0, std::ceil(width * base_ / spacing_));
      // A row's share of the area: 2 / rows of the mean width.
      const double part_area = area * 2 * width / rows_ / parts;
      for (double part = 0; part < parts; ++part) {
        const Vector3d at = origin + height * up + width * (part + 0.5) / parts * along;
        samples.push_back({from_eigen(at), rounded(shape_.normal), slot_, part_area});
      }
    }
  }

 private:
  Vector3d corner(std::size_t k) const { return to_eigen(shape_.vertices[k % 3]); }

  const TriangleShape& shape_;
  std::uint32_t slot_;
  double spacing_ = 0, base_ = 0, rows_ = 1;
  std::size_t first_ = 0;
};

Result<std::vector<SurfaceSample>> at_spacing(const TriangleStore& triangles,
                                              std::span<const std::uint32_t> slots, double spacing) {
  double most = 0;
  for (const std::uint32_t slot : slots) {
    if (has_area(triangles.shape(slot))) most += Rows(triangles.shape(slot), slot, spacing).upper_count();
  }
  if (!(most <= most_samples)) return Error{Code::bad_option, 0, "the spacing gives too many samples"};
  std::vector<SurfaceSample> samples;
  for (const std::uint32_t slot : slots) {
    if (has_area(triangles.shape(slot))) Rows(triangles.shape(slot), slot, spacing).append(samples);
  }
  return samples;
}

std::vector<SurfaceSample> at_faces(const TriangleStore& triangles, std::span<const std::uint32_t> slots) {
  std::vector<SurfaceSample> samples;
  samples.reserve(slots.size());
  for (const std::uint32_t slot : slots) {
    if (has_area(triangles.shape(slot))) samples.push_back(centre_of(triangles.shape(slot), slot));
  }
  return samples;
}

double angle_at(const TriangleShape& shape, std::size_t k) noexcept {
  const auto along = [&](std::size_t other) {
    return rounded(difference(shape.vertices[other % 3], shape.vertices[k]));
  };
  return angle_between(along(k + 1), along(k + 2));
}

/// Sums over the triangles of a vertex; `slot` is the lowest by number.
struct Fan {
  Vector3d normal = Vector3d::Zero();
  Vec3 position;
  std::uint32_t slot = no_index;
  double area = 0;
};

std::vector<SurfaceSample> at_vertices(const TriangleStore& triangles, std::span<const std::uint32_t> slots) {
  std::vector<Fan> fans;
  std::vector<std::uint32_t> order;
  for (const std::uint32_t slot : slots) {
    const TriangleShape& shape = triangles.shape(slot);
    if (!has_area(shape)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangles.records[slot].vertices[k];
      if (vertex >= fans.size()) fans.resize(std::size_t{vertex} + 1);
      Fan& fan = fans[vertex];
      if (fan.slot == no_index) {
        order.push_back(vertex);
        fan.slot = slot;
        fan.position = shape.vertices[k];
      }
      fan.normal += angle_at(shape, k) * to_eigen(rounded(shape.normal));
      fan.area += area_of(shape) / 3;
    }
  }
  std::vector<SurfaceSample> samples;
  for (const std::uint32_t vertex : order) {
    const Fan& fan = fans[vertex];
    // Of angles that add up to two turns or so, less than this is what rounding leaves where they cancel.
    const double length = fan.normal.norm();
    if (length > 0x1p-40)
      samples.push_back({fan.position, from_eigen(fan.normal / length), fan.slot, fan.area});
  }
  return samples;
}

}  // namespace

double area_of(const TriangleShape& shape) noexcept {
  const auto along = [&](std::size_t k) {
    return to_eigen(rounded(difference(shape.vertices[k], shape.vertices[0])));
  };
  return along(1).cross(along(2)).norm() / 2;
}

Result<std::vector<SurfaceSample>> surface_samples(const FieldData& field,
                                                   std::span<const std::uint32_t> slots, SampleAt at,
                                                   double spacing) {
  if (at == SampleAt::spacing) return at_spacing(field.triangles, slots, spacing);
  return at == SampleAt::vertices ? at_vertices(field.triangles, slots) : at_faces(field.triangles, slots);
}

}  // namespace cdfr
