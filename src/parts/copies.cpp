#include "parts/copies.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace cdfr {
namespace {

/// From one copy to the next. Most parts have an x that is a multiple of 2^-10, so with such a step sums
/// below 2^43 are exact: 2^32 triangles of the widest part, 600 mm, are not that far. The x of connector and
/// brevi are decimals, and a sum is the double nearest to the exact one: what is flat across x stays so, and
/// no two corners change places.
double step_of(const Mesh& part) noexcept {
  double width = 0;
  for (const Vec3& v : part.vertices) width = std::max(width, v.x);
  return std::ceil(width * 1.1 * 0x1p10) * 0x1p-10;
}

}  // namespace

Result<Mesh> copied(Mesh part, std::string_view name, std::uint64_t copies) {
  if (copies == 0) return Error{Code::bad_option, 0, "there must be one copy at least"};
  const std::size_t triangles = part.triangles.size(), vertices = part.vertices.size();
  const std::uint64_t most = (no_index - 1) / triangles;
  if (copies > most) {
    return Error{Code::bad_option, copies,
                 "a mesh has at most 2^32 - 2 triangles, which are " + std::to_string(most) + " copies of " +
                     std::string(name)};
  }
  const double step = step_of(part);
  part.vertices.reserve(copies * vertices);
  part.triangles.reserve(copies * triangles);
  for (std::uint64_t copy = 1; copy < copies; ++copy) {
    const double shift = static_cast<double>(copy) * step;
    for (std::size_t i = 0; i < vertices; ++i) {
      const Vec3 v = part.vertices[i];
      part.vertices.push_back({v.x + shift, v.y, v.z});
    }
    const auto first = static_cast<std::uint32_t>(copy * vertices);
    for (std::size_t i = 0; i < triangles; ++i) {
      const Triangle t = part.triangles[i];
      part.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  return part;
}

}  // namespace cdfr
