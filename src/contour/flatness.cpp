#include "contour/flatness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contour/covering.h"
#include "core/vector.h"

namespace cdfr {
namespace {

/// As near_triangles.cpp has it.
constexpr double rounding_share = 0x1p-36;

double half_spread(const Eigen::Vector3d& gradient, double size) noexcept {
  return gradient.lpNorm<1>() * (size / 2);
}

Eigen::Vector3d corner_offset(std::size_t corner, double size) noexcept {
  const double half = size / 2;
  return {corner & 1 ? half : -half, corner & 2 ? half : -half, corner & 4 ? half : -half};
}

/// By the tangent, or because the triangle is behind the plane of the feet.
bool explains(const FieldData& field, const Eigen::Vector3d& centre, const TangentPlane& plane,
              const NearTriangle& t, double size, double slack) noexcept {
  if (t.foot.distance - plane.value - half_spread(t.foot.gradient - plane.gradient, size) >= -slack)
    return true;
  for (const Vec3& vertex : field.triangles.shape(t.slot).vertices) {
    if (plane.gradient.dot(to_eigen(vertex) - centre) + plane.value > slack) return false;
  }
  return true;
}

/// The closest of those that no plane explains, or none.
const NearTriangle* unexplained(const FieldData& field, const Eigen::Vector3d& centre, const Flatness& flat,
                                double size, double slack, const std::vector<NearTriangle>& near) noexcept {
  const NearTriangle* closest = nullptr;
  for (const NearTriangle& t : near) {
    if (closest != nullptr && t.foot.distance >= closest->foot.distance) continue;
    bool explained = false;
    for (int i = 0; i < flat.planes && !explained; ++i)
      explained = explains(field, centre, flat.plane[i], t, size, slack);
    if (!explained) closest = &t;
  }
  return closest;
}

using AtCorners = std::array<double, 8>;

AtCorners at_corners(const FieldData& field, const Eigen::Vector3d& centre, double size,
                     std::uint32_t slot) noexcept {
  AtCorners distances;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    distances[corner] =
        plain_foot(centre + corner_offset(corner, size), field.triangles.shape(slot)).distance;
  }
  return distances;
}

/// Is the distance at most the plane and the slack, by one triangle?
bool stays_below(const FieldData& field, const Eigen::Vector3d& centre, double size, double slack,
                 const TangentPlane& plane, std::uint32_t slot) noexcept {
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d offset = corner_offset(corner, size);
    const double distance = plain_foot(centre + offset, field.triangles.shape(slot)).distance;
    if (distance > plane.value + plane.gradient.dot(offset) + slack) return false;
  }
  return true;
}

}  // namespace

namespace {

/// At most so many planes, each within the same slack.
Flatness few_planes(const FieldData& field, const Eigen::Vector3d& centre, double size, int most_planes,
                    double below, double above, const std::vector<NearTriangle>& near) {
  Flatness flat;
  std::array<std::uint32_t, 3> slots{};
  while (const NearTriangle* next = unexplained(field, centre, flat, size, below, near)) {
    if (flat.planes == most_planes || next->foot.gradient.isZero(0)) return {};
    slots[flat.planes] = next->slot;
    flat.plane[flat.planes++] = {next->foot.distance, next->foot.gradient};
  }
  const double rounding = rounding_share * (flat.plane[0].value + size);
  flat.least = flat.most = std::numeric_limits<double>::infinity();
  for (int i = 0; i < flat.planes; ++i) {
    const TangentPlane& plane = flat.plane[i];
    if (!stays_below(field, centre, size, above, plane, slots[i]) &&
        !covers(field, centre, size, plane.gradient, plane.value, above, near)) {
      return {};
    }
    const double spread = half_spread(plane.gradient, size);
    flat.least = std::min(flat.least, plane.value - spread - below - rounding);
    flat.most = std::min(flat.most, plane.value + spread + above + rounding);
  }
  return flat;
}

/// No two planes meet at more than 60 degrees.
bool is_gentle(const Flatness& flat) noexcept {
  for (int i = 0; i < flat.planes; ++i) {
    for (int j = 0; j < i; ++j) {
      if (flat.plane[i].gradient.dot(flat.plane[j].gradient) < 0.5) return false;
    }
  }
  return flat.planes > 0;
}

}  // namespace

Flatness flatness(const FieldData& field, const Eigen::Vector3d& centre, double size, const Slack& slack,
                  const std::vector<NearTriangle>& near) {
  const Flatness one = few_planes(field, centre, size, 1, slack.below, slack.above, near);
  if (one.planes == 1) return one;
  const Flatness gentle = few_planes(field, centre, size, 3, slack.below, slack.above, near);
  return is_gentle(gentle) ? gentle : few_planes(field, centre, size, 3, slack.sharp, slack.sharp, near);
}

bool is_sheet(const FieldData& field, const Eigen::Vector3d& centre, double size, const Slack& slack,
              const TangentPlane& plane, const std::vector<NearTriangle>& near) {
  const TangentPlane turned{-plane.value, -plane.gradient};
  for (const NearTriangle& t : near) {
    if (!explains(field, centre, plane, t, size, slack.below)) return false;
    if (!explains(field, centre, turned, t, size, slack.below)) return false;
  }
  return covers(field, centre, size, plane.gradient, plane.value, slack.above, near);
}

Flatness distance_bounds(const FieldData& field, const Eigen::Vector3d& centre, double size,
                         const std::vector<NearTriangle>& near) {
  Flatness bounds;
  bounds.least = bounds.most = std::numeric_limits<double>::infinity();
  // The closest few give the upper bounds.
  std::array<const NearTriangle*, 4> closest{};
  std::size_t count = 0;
  for (const NearTriangle& t : near) {
    bounds.least = std::min(bounds.least, t.foot.distance - half_spread(t.foot.gradient, size));
    std::size_t at = count;
    for (; at > 0 && closest[at - 1]->foot.distance > t.foot.distance; --at) {
      if (at < closest.size()) closest[at] = closest[at - 1];
    }
    if (at < closest.size()) closest[at] = &t;
    count = std::min(count + 1, closest.size());
  }
  std::array<AtCorners, 4> distances;
  for (std::size_t i = 0; i < count; ++i) {
    distances[i] = at_corners(field, centre, size, closest[i]->slot);
    for (std::size_t j = 0; j <= i; ++j) {
      double largest = 0;
      for (std::size_t corner = 0; corner < 8; ++corner)
        largest = std::max(largest, (distances[i][corner] + distances[j][corner]) / 2);
      bounds.most = std::min(bounds.most, largest);
    }
  }
  const double rounding = rounding_share * (bounds.most + size);
  bounds.least = std::max(bounds.least - rounding, 0.0);
  bounds.most += rounding;
  return bounds;
}

namespace {

/// An upper bound on the least of the planes over the corners given, as in distance_bounds.
template <class Corners>
double most_over(const Flatness& flat, const std::array<std::array<double, 8>, 3>& values,
                 const Corners& corners) {
  double bound = std::numeric_limits<double>::infinity();
  for (int i = 0; i < flat.planes; ++i) {
    for (int j = 0; j <= i; ++j) {
      double largest = -std::numeric_limits<double>::infinity();
      for (const int corner : corners)
        largest = std::max(largest, (values[i][corner] + values[j][corner]) / 2);
      bound = std::min(bound, largest);
    }
  }
  return bound;
}

}  // namespace

double hidden_above(const Flatness& flat, double size, double height) noexcept {
  if (flat.planes < 2) return 0;
  std::array<std::array<double, 8>, 3> values{};
  std::array<bool, 8> below{};
  for (std::size_t corner = 0; corner < 8; ++corner) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < flat.planes; ++i) {
      values[i][corner] = flat.plane[i].value + flat.plane[i].gradient.dot(corner_offset(corner, size));
      least = std::min(least, values[i][corner]);
    }
    below[corner] = least < height;
  }
  double hidden = 0;
  const auto look = [&](const auto& corners) {
    for (const int corner : corners) {
      if (!below[corner]) return;
    }
    hidden = std::max(hidden, most_over(flat, values, corners) - height);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, w = 1 << (axis + 2) % 3, along = 1 << axis;
    for (const int corner : {0, u, w, u | w}) look(std::array{corner, corner | along});
    for (const int base : {0, along}) look(std::array{base, base | u, base | w, base | u | w});
  }
  return hidden;
}

}  // namespace cdfr
