/// Solids made of cells of a rectilinear grid: closed meshes whose signed distance has a closed form.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "cdfr/mesh/mesh.h"
#include "support/random.h"

namespace cdfr::test {

using Planes = std::vector<double>;

class BlockSolid {
 public:
  using Filled = std::function<bool(int, int, int)>;

  /// Cell (i, j, k) lies between planes i and i + 1 along x, and so on; planes ascend.
  BlockSolid(Planes x, Planes y, Planes z, const Filled& filled)
      : planes_{std::move(x), std::move(y), std::move(z)} {
    for (int i = 0; i < cells(0); ++i) {
      for (int j = 0; j < cells(1); ++j) {
        for (int k = 0; k < cells(2); ++k) {
          if (!filled(i, j, k)) continue;
          filled_.push_back(box_of({i, j, k}));
          for (int way = 0; way < 6; ++way) add_face({i, j, k}, way, filled);
        }
      }
    }
  }

  const Mesh& mesh() const { return mesh_; }
  const Planes& planes(std::size_t axis) const { return planes_[axis]; }
  Box box() const {
    return {{planes_[0].front(), planes_[1].front(), planes_[2].front()},
            {planes_[0].back(), planes_[1].back(), planes_[2].back()}};
  }

  /// To 2^-60 of itself; negative inside.
  long double distance(const Vec3& p) const {
    long double least = HUGE_VALL;
    for (const Box& face : faces_) least = std::min(least, distance_to(face, p));
    if (least == 0) return 0;
    for (const Box& cell : filled_) {
      if (distance_to(cell, p) == 0) return -least;
    }
    return least;
  }

 private:
  using Place = std::array<int, 3>;

  int cells(std::size_t axis) const { return static_cast<int>(planes_[axis].size()) - 1; }

  Vec3 corner(const Place& at) const {
    return {planes_[0][static_cast<std::size_t>(at[0])], planes_[1][static_cast<std::size_t>(at[1])],
            planes_[2][static_cast<std::size_t>(at[2])]};
  }
  Box box_of(const Place& at) const { return {corner(at), corner({at[0] + 1, at[1] + 1, at[2] + 1})}; }

  static long double distance_to(const Box& box, const Vec3& p) {
    const auto beyond = [](double x, double lo, double hi) {
      const auto v = static_cast<long double>(x);
      return x < lo ? lo - v : (x > hi ? v - hi : 0.0L);
    };
    const std::array<long double, 3> d{beyond(p.x, box.lo.x, box.hi.x), beyond(p.y, box.lo.y, box.hi.y),
                                       beyond(p.z, box.lo.z, box.hi.z)};
    return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  }

  void add_face(const Place& cell, int way, const Filled& filled) {
    const auto axis = static_cast<std::size_t>(way / 2);
    const bool upper = way % 2 != 0;
    Place next = cell;
    next[axis] += upper ? 1 : -1;
    const bool within = next[axis] >= 0 && next[axis] < cells(axis);
    if (within && filled(next[0], next[1], next[2])) return;
    const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
    std::array<std::uint32_t, 4> at{};
    for (std::size_t k = 0; k < 4; ++k) {
      Place place = cell;
      place[axis] += upper ? 1 : 0;
      place[b] += k == 1 || k == 2 ? 1 : 0;
      place[c] += k >= 2 ? 1 : 0;
      at[upper ? k : 3 - k] = vertex(place);
    }
    mesh_.triangles.push_back({at[0], at[1], at[2]});
    mesh_.triangles.push_back({at[0], at[2], at[3]});
    const Vec3 p = mesh_.vertices[at[0]], q = mesh_.vertices[at[2]];
    faces_.push_back({{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
                      {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}});
  }

  std::uint32_t vertex(const Place& place) {
    const auto [at, is_new] = numbers_.try_emplace(place, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.push_back(corner(place));
    return at->second;
  }

  std::array<Planes, 3> planes_;
  Mesh mesh_;
  std::vector<Box> faces_, filled_;
  std::map<Place, std::uint32_t> numbers_;
};

inline BlockSolid block(const Box& box) {
  return {
      {box.lo.x, box.hi.x}, {box.lo.y, box.hi.y}, {box.lo.z, box.hi.z}, [](int, int, int) { return true; }};
}

/// In the grown box, on a plane of the grid, or beside one by a size of any order down to 2^-70 of the
/// solid's.
inline Vec3 point_near(const BlockSolid& solid, Random& random) {
  const Box around = scaled(solid.box(), 1.5);
  const double size = longest(solid.box());
  Vec3 p = random.in(around);
  const auto place = [&](std::size_t axis, double anywhere) {
    const Planes& planes = solid.planes(axis);
    const double on = planes[random.below(planes.size())];
    switch (random.below(4)) {
      case 0:
        return on;
      case 1:
        return on + std::ldexp(random.between(-1, 1) * size, -static_cast<int>(random.below(70)));
      case 2:
        return random.between(planes.front(), planes.back());
      default:
        return anywhere;
    }
  };
  return {place(0, p.x), place(1, p.y), place(2, p.z)};
}

}  // namespace cdfr::test
