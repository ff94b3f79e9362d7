#include "geometry/place_estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geometry/offset.h"
#include "geometry/point_triangle.h"

namespace cdfr {
namespace {

double dot(const Vec3& a, const Vec3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

double sum_of_magnitudes(const Vec3& v) noexcept { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

/// An edge from one corner on, and p from there.
struct Edge {
  Vec3 e, r;
  double size;   ///< |e|_1 + |r|_1: at least |p - v|_1 of either end
  double doubt;  ///< 16u |e|_1 size
};

Edge edge_of(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const Vec3 e = minus(triangle.vertices[(k + 1) % 3], triangle.vertices[k]);
  const Vec3 r = minus(p, triangle.vertices[k]);
  const double length = sum_of_magnitudes(e);
  const double size = length + sum_of_magnitudes(r);
  return {e, r, size, 16 * unit_roundoff * length * size};
}

/// Twice the signed area that p's projection spans with the edge, positive inside. Products carry two
/// differences and one multiplication, the cross product one subtraction, the dot product one multiplication,
/// the normal's rounding and two sums: 8u of |e|_1 |r|_1; 16u covers second order. The size of either end in
/// the bound leaves room for the kernel's test, which asks for 2^-96 |e|_1 |r|_1 from one of them.
double area_beside(const Edge& edge, const Vec3& n) noexcept {
  const auto& [e, r, size, doubt] = edge;
  return (e.y * r.z - e.z * r.y) * n.x + (e.z * r.x - e.x * r.z) * n.y + (e.x * r.y - e.y * r.x) * n.z;
}

struct EdgeEstimate {
  double squared;
  int place;  ///< the edge or its end where the kernel certainly finds the edge's foot, or unsure_place
};

/// The root of `squared` is off by less than 26u R: the clamped parameter moves the foot by at most 17u R
/// along the edge, differences, products and the root add 9u R.
///
/// s = r.e and |e|^2 are off by 5u of |r|_1 |e|_1 and |e|_1^2 (two differences, one multiplication, two
/// sums), their difference by one rounding more. The kernel's, from either end, are off by far less than the
/// 10u that are left. So beyond 16u they tell to which end it clamps the foot, or that it does not.
EdgeEstimate estimate_edge(const Edge& edge, int k) noexcept {
  const auto& [e, r, size, doubt] = edge;
  const double length = dot(e, e);
  const double s = dot(r, e);
  const double ratio = s / length;
  const double t = s > 0 ? (s < length ? ratio : 1) : 0;
  const Vec3 o{r.x - t * e.x, r.y - t * e.y, r.z - t * e.z};
  int place = s > doubt && length - s > doubt ? 1 + k : unsure_place;
  if (s < -doubt) place = 4 + k;
  if (length - s < -doubt) place = 4 + (k + 1) % 3;
  return {dot(o, o), place};
}

/// Which edges may be closest, and the place in which all of those agree. The bound on a distance is stated
/// with the largest |r|_1 + |e|_1 >= R; one root serves all three. A distance above its bound exceeds 38u R,
/// far more than what the kernel may take for zero.
void compare(const std::array<EdgeEstimate, 3>& feet, double size, PlaceEstimate& estimate) noexcept {
  const double least = std::sqrt(std::min({feet[0].squared, feet[1].squared, feet[2].squared}));
  const double bound = 64 * unit_roundoff * size;
  const double most = (least + 2 * bound) * (least + 2 * bound);
  unsigned places = 0;  // one bit each
  for (int k = 0; k < 3; ++k) {
    estimate.may_be_least[k] = feet[k].squared <= most;
    places |= unsigned{estimate.may_be_least[k]} << feet[k].place;
  }
  if (estimate.outside && least > bound && std::has_single_bit(places)) {
    estimate.place = static_cast<TrianglePlace>(std::countr_zero(places));
  }
}

}  // namespace

PlaceEstimate estimate_place(const Vec3& p, const TriangleShape& triangle) noexcept {
  PlaceEstimate estimate;
  const Vec3 n = rounded(triangle.normal);
  std::array<Edge, 3> edges;
  estimate.outside = n == Vec3{};
  for (int k = 0; k < 3; ++k) {
    edges[k] = edge_of(p, triangle, k);
    const double area = area_beside(edges[k], n);
    estimate.beside[k] = area > edges[k].doubt;
    estimate.outside |= area < -edges[k].doubt;
  }
  if (estimate.beside[0] && estimate.beside[1] && estimate.beside[2]) {
    estimate.place = 0;
    return estimate;
  }
  std::array<EdgeEstimate, 3> feet;
  for (int k = 0; k < 3; ++k) feet[k] = estimate_edge(edges[k], k);
  compare(feet, std::max({edges[0].size, edges[1].size, edges[2].size}), estimate);
  return estimate;
}

}  // namespace cdfr
