/// Many points of one leaf against the leaf's list: each triangle meets a vector of points at a time, in
/// single precision, and whole boxes of points drop triangles that are closest to none of them.
///
/// Coordinates are in units of the lattice's edge, relative to the middle c of the points, and rounded to
/// single precision once. Let r be the largest |p - c|, D the longest edge of a triangle, d the distance from
/// p to a triangle T, so that every vertex is within q = d + D of p and within S = d + D + r of c.
///
/// **Bound.** With u = 2^-24, to first order:
///  - Rounding moves p by at most u r and T's vertices by u S: T becomes T^, its distance from p changes by
///    (2S - q) u at most.
///  - An edge. For the t that is taken, p minus the edge's point at t is off by u (q + 2D + q): roundings of
///  r,
///    e, t e and the difference; its length by another 1.5u q. The product r.e is off by 5u q|e|, |e|^2 by 5u,
///    its reciprocal and the product with that by 2u: t |e| by 12u q, which only adds, at a right angle.
///  - The face counts where all r.(n x e) exceed 16u |e|_1 |r|_1; their own error is 8.5u |e| q. So along n p
///    is above T^, whose edges are at a right angle with n but for 2u S + u D; the height is off by that, and
///    by u q (r), 3u q (the product) and 2u d (|n| is 1 but for u).
///  - Where p is above T and the face is given up, p is inside some edge of T^, seen along n, by at most 16u
///    * 3 (q + D) + 8.5u q + u d < 108u S, and T^ is level there but for 2u S: the border is that far away,
///    at a right angle, and the height is off by 2u S more.
/// So what an estimate is too small by is first order alone, below 12u S; and what it is too large by is below
/// that but for at most 109u S at a right angle. With tile_error = 16u, tile_slip = 128u, reach = D + r and
/// scan_floor for what scan_group.h has it for and for |e| < 2^-63, whose squares lose digits,
///     d - (tile_error (d + reach) + f) <= estimate <= sqrt(d^2 + (tile_slip (d + reach))^2) + tile_error (d +
///     reach) + f.
/// Both constants have room for the roundings of thresholds, and f for what separates computed distances that
/// tie (scan.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/place_estimate.h"
#include "geometry/scan_group.h"
#include "mesh/triangles.h"
#include "octree/blocks.h"

namespace cdfr {

inline constexpr float tile_error = 16 * 0x1p-24F;
inline constexpr float tile_slip = 128 * 0x1p-24F;

/// With the true r and e in the place of the rounded ones, products r.e and r.(n x e) are off by less than
/// 18u S^2: r is off by 3u S, e, at most S long itself, by 2u S and u D, and their product's own arithmetic
/// adds 9.5u q D at most; |e|^2 - r.e by another 9u S^2. What is larger says for certain on which side of an
/// edge, and before, on or behind it, the kernel finds a point.
inline constexpr float place_doubt = 32 * 0x1p-24F;

/// A triangle with what does not depend on the point.
struct TileTriangle {
  struct Edge {
    float along[3];      ///< e
    float length, over;  ///< |e|^2 and its reciprocal
    float inwards[3];    ///< n x e
    float doubt;         ///< in a product with that, where |r|_1 = 1
  };
  float a[3], b[3];
  Edge ab, bc, ca;
  float normal[3];
  float extent;  ///< largest |e|_1 of the edges at a
  std::uint32_t slot;
  std::array<std::uint64_t, 6> features;  ///< names of its edges and vertices, by place - 1
};

/// A leaf's list as seen from the middle of the points.
struct TileList {
  static constexpr std::size_t most = 256;
  std::vector<TileTriangle> triangles;
  float reach;

  /// False if the list holds BVH nodes or more triangles than that. `middle` and `radius` in edges from the
  /// lattice's origin.
  bool fill(const TriangleStore& store, const Lattice& lattice,
            std::span<const Entry> list, const Vec3& middle, double radius);
};

/// Places in TileList::triangles.
using TileNumbers = std::span<const std::uint16_t>;

/// The points of a tile; `count` of them count, the rest are any numbers.
struct TilePoints {
  static constexpr std::size_t most = 64;
  alignas(64) float at[3][most];
  std::uint32_t count;
};

struct TileBox {
  float lo[3], hi[3];
};

/// Writes to `kept` those of the numbers that may be closest to a point of the box, and returns how many.
///
/// A triangle is convex, so d(P,T')^2 is a convex function of P; d(P,T)^2 - |P|^2 is concave (influence.h).
/// With the weights w that make P of the box's corners C (trilinear, so that they do the same for each axis)
///     d(P,T)^2 - d(P,T')^2 >= sum of w (d(C,T)^2 - d(C,T')^2) - (sum of w |C|^2 - |P|^2),
/// and the last bracket, the variance of the corners under w, is at most m = (e_1^2 + e_2^2 + e_3^2) / 4 for
/// edges e. So T is closest nowhere if d(C,T)^2 - d(C,T')^2 > m at all corners. With estimates t and t' it
/// is so if t > (sqrt(U^2 + s^2 + m) + k reach + f) (1 + 2 k), where U = t' + k (t' + reach) + f is at least
/// d(C,T'), s = tile_slip (U + reach), k = tile_error and f = scan_floor. The points' true box rounds to this one, corner by corner; its edges are longer by 4u r at
/// most. T' are the triangles closest to the corners and to the octants' centres.
std::size_t prune(const TileList& list, TileNumbers numbers, const TileBox& box,
                  std::uint16_t* kept) noexcept;

/// What a scan has left, by point. Of several triangles on which the kernel certainly finds the same edge's or
/// vertex's foot, hence the same bits (race.cpp), one is kept. A place is certain where every edge says by
/// more than place_doubt on which side of it the projection is, and before, on or behind it; on the border,
/// those edges that may be closest by estimates have to agree, and the distance must not be about zero.
struct TileFindings {
  static constexpr std::size_t most = 64;
  std::array<std::uint16_t, most> survivors;  ///< numbers that may be closest to some point
  std::size_t count;                          ///< of the above that are set
  alignas(64) float number[TilePoints::most];  ///< of the triangle that is closest
  alignas(64) float place[TilePoints::most];   ///< of the foot there; or unsure_place, and the number is open:
  std::uint64_t kept[TilePoints::most];        ///< bit k is set if survivors[k] may be closest
};

/// False, and nothing of use in `found`, if there are more survivors than that.
bool scan_tile(const TileList& list, TileNumbers numbers, const TilePoints& points,
               TileFindings& found) noexcept;

}  // namespace cdfr
