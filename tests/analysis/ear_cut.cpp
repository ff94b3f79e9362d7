#include "analysis/ear_cut.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace cdfr::test {
namespace {

/// How far p is left of the line from a to b.
double left_of(Point2 a, Point2 b, Point2 p) {
  return ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / std::hypot(b.x - a.x, b.y - a.y);
}

}  // namespace

// An ear is three corners in a row that turn left and hold no other corner, on the border neither: corners of
// other sides often lie on the line of a cut. Every simple polygon has such ears.
std::vector<std::array<std::uint32_t, 3>> cut_ears(const std::vector<Point2>& polygon) {
  constexpr double apart = 1e-10;
  std::vector<std::uint32_t> ring(polygon.size());
  std::iota(ring.begin(), ring.end(), 0U);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto is_ear = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Point2 p = polygon[a], q = polygon[b], r = polygon[c];
    if (left_of(p, r, q) > -apart) return false;
    return std::ranges::none_of(ring, [&](std::uint32_t other) {
      if (other == a || other == b || other == c) return false;
      const Point2 o = polygon[other];
      return left_of(p, q, o) > -apart && left_of(q, r, o) > -apart && left_of(r, p, o) > -apart;
    });
  };
  while (ring.size() > 3) {
    const std::size_t n = ring.size(), before = triangles.size();
    for (std::size_t i = 0; i < n && triangles.size() == before; ++i) {
      const std::uint32_t a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
      if (!is_ear(a, b, c)) continue;
      triangles.push_back({a, b, c});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>((i + 1) % n));
    }
    if (triangles.size() == before) throw std::logic_error("a polygon without ears");
  }
  triangles.push_back({ring[0], ring[1], ring[2]});
  return triangles;
}

}  // namespace cdfr::test
