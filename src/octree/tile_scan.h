/// Many points of one leaf against the leaf's list: each triangle meets a vector of points at a time, in
/// single precision, and whole boxes of points drop triangles that are closest to none of them.
///
/// Coordinates are in units of the lattice's edge, relative to the middle c of the points. A triangle is
/// given by a frame for each edge: x along it from its first vertex, y inwards, and h along the normal, which
/// all three share. Frames and their origins are computed in double and rounded to single precision once. So
/// between vertices the distance is sqrt(y^2 + h^2), before and behind them x counts too, and above the face
/// h alone.
///
/// **Bound.** Let u = 2^-24, r the largest |p - c|, V the largest |v - c| of the triangle's vertices, D the
/// longest edge of the list, d the distance from p to a triangle T; V <= S = d + D + r.
///  - A coordinate is f.p - f.v. Rounding the frame, p and f.v moves it by u r, u r and u V, three sums round
///    by u (V + r) each, and products, where they are not fused, by 2u r: in all u (4V + 7r) at most, below
///    11u S.
///  - The length of an edge is off by u D. So x beyond the edge is off by 13u S with its own rounding, the
///    vector (x, y, h) by sqrt(11^2 + 11^2 + 13^2) < 21u S, and its length by another 1.5u (d + D): 23u S.
///  - The face counts where all y exceed 8u (V + r) >= u (4V + 7r): p is above it for certain. Where the face
///    is given up though p is above it, p is inside some edge by at most u (12V + 15r) < 28u S: the border is
///    that far away, at a right angle to d.
/// With tile_error = 32u, tile_slip = 32u, reach = D + r and scan_floor for what scan_group.h has it for and
/// for coordinates below 2^-63, whose squares lose digits,
///     d - (tile_error (d + reach) + f) <= estimate <= sqrt(d^2 + (tile_slip (d + reach))^2) + tile_error (d
///     + reach) + f.
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

inline constexpr float tile_error = 32 * 0x1p-24F;
inline constexpr float tile_slip = 32 * 0x1p-24F;
/// Of V + r: a coordinate that is larger has its sign for certain, with an edge's length, at most 2V, and
/// without.
inline constexpr float tile_doubt = 8 * 0x1p-24F;

/// A triangle with what does not depend on the point.
struct alignas(64) TileTriangle {
  struct Axis {
    float way[3], start;  ///< the coordinate of p is way.p - start
  };
  struct Edge {
    Axis along, inwards;
    float length;
  };
  Edge edges[3];
  Axis height;
  float doubt;  ///< infinite for a triangle of no area: its face never counts, no place on it is certain
};
static_assert(sizeof(TileTriangle) == 128);

/// A leaf's list as seen from the middle of the points.
struct TileList {
  static constexpr std::size_t most = 512;
  std::vector<TileTriangle> triangles;
  std::vector<std::uint32_t> slots;
  const TriangleStore* store;
  float reach;

  /// False if the list holds BVH nodes or more triangles than that. `middle` and `radius` in edges from the
  /// lattice's origin.
  bool fill(const TriangleStore& store, const Lattice& lattice, std::span<const Entry> list,
            const Vec3& middle, double radius);
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
/// d(C,T'), s = tile_slip (U + reach), k = tile_error and f = scan_floor. The points' true box rounds to this
/// one, corner by corner; its edges are longer by 4u r at most. T' are the triangles closest to the corners
/// and to the octants' centres.
std::size_t prune(const TileList& list, TileNumbers numbers, const TileBox& box,
                  std::uint16_t* kept) noexcept;

/// What a scan has left, by point. Of several triangles on which the kernel certainly finds the same edge's
/// or vertex's foot, hence the same bits (race.cpp), one is kept. A place is certain where every edge says
/// beyond doubt on which side of it the projection is, and before, on or behind it; on the border, those
/// edges that may be closest by estimates have to agree, and the distance must not be about zero.
struct TileFindings {
  static constexpr std::size_t most = 64;
  std::array<std::uint16_t, most> survivors;   ///< numbers that may be closest to some point
  std::size_t count;                           ///< of the above that are set
  alignas(64) float number[TilePoints::most];  ///< of the triangle that is closest
  alignas(64) float place[TilePoints::most];  ///< of the foot there; or unsure_place, and the number is open:
  std::uint64_t kept[TilePoints::most];       ///< bit k is set if survivors[k] may be closest
};

/// False, and nothing of use in `found`, if there are more survivors than that.
bool scan_tile(const TileList& list, TileNumbers numbers, const TilePoints& points,
               TileFindings& found) noexcept;

}  // namespace cdfr
