/// What one evaluation at the centre of a cube tells of all of it: which triangles may be closest somewhere
/// in it, and where in it a distance may be taken.
///
/// Let c be the centre, d a triangle's distance from there, f its foot, g = (c - f)/d. The triangle is
/// convex, so it lies behind the plane through f across g, its **support**: d(c + x) >= d + g.x for every x.
///
/// With W the triangle closest to c, at distance w: d_W(c + x) <= |c + x - f_W| <= w + g_W.x + |x|^2/(2w),
/// and the last term is absent where W's face holds the feet of the whole cube. So T is closest nowhere in
/// the cube of half edge h if
///     d - w > h |g_W - g|_1 + 3 h^2/(2w),
/// for what is left of the difference is linear, and largest at a corner. And the least distance L of all
/// supports at a point bounds the distance there: L <= distance <= L + |x|^2/(2w), for each triangle's own d
/// is w at least.
///
/// **Rounding.** Let e bound the frames' errors (feet.h), R = sqrt(3) h <= 2w. Distances and feet are off by
/// e, so g by 2e/d, and g.x by 2e R/d <= 4e. Sums are short and round by less than e: a support is off by 6e,
/// and a computed distance below it by 7e: support_slack is 8. In the test of T there are two distances at c,
/// two supports' directions and two computed distances at the point: 2e + 8e + 2e and sums, less than 16e.
/// Closer cubes, w < h, keep all triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/feet.h"

namespace cdfr {

/// Times the largest TriangleFrame::error: what a support may be above the triangle's computed distance.
inline constexpr double support_slack = 8;

/// Of one triangle, as seen from the centres of up to eight cubes.
struct alignas(64) Support {
  static constexpr std::size_t most = 8;
  double distance[most];
  double way[3][most];  ///< unit, from the foot to the centre
};

/// Of a list of triangles, for up to eight cubes of one size.
struct Supports {
  static constexpr std::size_t most_numbers = 512;
  std::array<Support, most_numbers> of;                 ///< by place in the list, if it is near any cube
  std::array<std::uint8_t, most_numbers> near;          ///< bit i: it may be closest somewhere in cube i
  alignas(64) std::array<double, Support::most> least;  ///< distances from the centres
  double half;                                          ///< of a cube's edge

  /// A coordinate that is at most the triangle's distance all over the cube: from the support, or, of a
  /// triangle too close for that, the least that slope 1 allows.
  TriangleFrame::Axis axis(std::size_t place, std::size_t cube, const Vec3& centre) const noexcept {
    const Support& own = of[place];
    const double d = own.distance[cube];
    if (d < half) return {{0, 0, 0}, 1.75 * half - d};
    const double x = own.way[0][cube], y = own.way[1][cube], z = own.way[2][cube];
    return {{x, y, z}, x * centre.x + y * centre.y + z * centre.z - d};
  }
};

/// Cubes of half edge `half` about the centres, at most Support::most; `error` is the largest of the frames'.
/// Supports in `near` are those of a larger cube that holds them all, and spare most of the work if its
/// closest triangle comes first.
void find_supports(const NearTriangles& near, const RegionPoints& centres, double half, double error,
                   Supports& supports) noexcept;

/// A cube of `along`^3 smaller ones, 1, 2 or 4 a side.
struct SmallCubes {
  Vec3 centre;
  std::size_t along;
  double size;  ///< of a small one
};

/// Replaces `centres` by those centres of small cubes, in Morton order, whose distance may be from `lo` to
/// `hi`, by the supports of all triangles that may be closest there. `closest` is the least distance from the
/// cube's centre. Precondition: sqrt(3)/2 of the cube's edge <= 2 closest.
void find_between(std::span<const TriangleFrame::Axis> supports, const SmallCubes& cubes, double closest,
                  double lo, double hi, RegionPoints& centres) noexcept;

}  // namespace cdfr
