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

using Corners = std::array<Vector3d, 3>;

Corners corners_of(const TriangleShape& shape) noexcept {
  return {to_eigen(shape.vertices[0]), to_eigen(shape.vertices[1]), to_eigen(shape.vertices[2])};
}

/// `sample` with the centre and the area for place and share.
SurfaceSample centred(SurfaceSample sample, const Corners& c, double area) noexcept {
  sample.position = from_eigen((c[0] + c[1] + c[2]) / 3);
  sample.area = area;
  return sample;
}

/// The centres of the parts; `sample` has what they share. Rounding of middles does not add up: each is the
/// mean of its ends' and its own.
void halve(const Corners& c, double area, double longest_part, const SurfaceSample& sample,
           std::vector<SurfaceSample>& samples) {
  std::size_t k = 0;
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = (c[(i + 1) % 3] - c[i]).norm();
    if (length > longest) longest = length, k = i;
  }
  if (longest <= longest_part) return samples.push_back(centred(sample, c, area));
  const Vector3d &a = c[k], &b = c[(k + 1) % 3], &tip = c[(k + 2) % 3];
  const Vector3d middle = (a + b) / 2;
  halve({a, middle, tip}, area / 2, longest_part, sample, samples);
  halve({middle, b, tip}, area / 2, longest_part, sample, samples);
}

SurfaceSample begun(const TriangleStore& triangles, std::uint32_t slot,
                    std::span<const double> facets) noexcept {
  return {{}, rounded(triangles.shape(slot).normal), slot, 0, facets[slot]};
}

Result<std::vector<SurfaceSample>> at_spacing(const TriangleStore& triangles,
                                              std::span<const std::uint32_t> slots,
                                              std::span<const double> facets, double spacing) {
  const double longest_part = 1.5 * spacing;
  double area = 0;
  for (const std::uint32_t slot : slots) area += area_of(triangles.shape(slot));
  // A part is no larger than half the square over its longest side.
  const bool too_many = !(area / (longest_part * longest_part / 2) <= most_samples);
  std::vector<SurfaceSample> samples;
  for (const std::uint32_t slot : slots) {
    if (too_many || static_cast<double>(samples.size()) > most_samples)
      return Error{Code::bad_option, 0, "the spacing gives too many samples"};
    const TriangleShape& shape = triangles.shape(slot);
    if (!has_area(shape)) continue;
    halve(corners_of(shape), area_of(shape), longest_part, begun(triangles, slot, facets), samples);
  }
  return samples;
}

std::vector<SurfaceSample> at_faces(const TriangleStore& triangles, std::span<const std::uint32_t> slots,
                                    std::span<const double> facets) {
  std::vector<SurfaceSample> samples;
  samples.reserve(slots.size());
  for (const std::uint32_t slot : slots) {
    const TriangleShape& shape = triangles.shape(slot);
    if (has_area(shape))
      samples.push_back(centred(begun(triangles, slot, facets), corners_of(shape), area_of(shape)));
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
  double area = 0, facet = 0;
};

std::vector<SurfaceSample> at_vertices(const TriangleStore& triangles, std::span<const std::uint32_t> slots,
                                       std::span<const double> facets) {
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
      fan.facet = std::max(fan.facet, facets[slot]);
    }
  }
  std::vector<SurfaceSample> samples;
  for (const std::uint32_t vertex : order) {
    const Fan& fan = fans[vertex];
    // Of angles that add up to two turns or so, less than this is what rounding leaves where they cancel.
    const double length = fan.normal.norm();
    if (!(length > 0x1p-40)) continue;
    samples.push_back({fan.position, from_eigen(fan.normal / length), fan.slot, fan.area, fan.facet});
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
                                                   std::span<const std::uint32_t> slots,
                                                   std::span<const double> facets, SampleAt at,
                                                   double spacing) {
  if (at == SampleAt::spacing) return at_spacing(field.triangles, slots, facets, spacing);
  return at == SampleAt::vertices ? at_vertices(field.triangles, slots, facets)
                                  : at_faces(field.triangles, slots, facets);
}

}  // namespace cdfr
