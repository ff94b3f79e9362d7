/// Eight triangles side by side in few bits: a third of the cache lines of a TriangleGroup, and twice the
/// lanes. A query looks through these first; what may be closest by them is measured in double-double.
///
/// Vertices are whole numbers of 16 bits from the group's origin, in the group's own unit. Arithmetic is in
/// single precision, in that unit. So what rounding does goes with the size of the group and with the
/// distance from it, not with the size of the mesh. Lengths below are in edges of the lattice.
///
/// **Bound.** Let u = 2^-24, D = reach() (no two points of the group are farther apart) and d the distance
/// from p to one of its triangles; every vertex is within d + D of p.
///  - Rounded vertices are within sqrt(3)/2 units of the true ones, below 2^-16 D: D is 2 sqrt(3) 32767 units
///  at
///    least. The triangle T' that they span is as close to p as T but for that. Where the face counts, p's
///    projection along T's normal is certainly inside T' seen along that normal, hence within 2^-16 D of T,
///    and the height above T' vertex is off by another 2^-16 D.
///  - The estimate's own arithmetic is triangle_group.h's with this u, 98u (d + D); products may be fused,
///  which
///    lowers errors. Rounding p and the normal to single precision adds 3u (d + D).
///  - p minus the lattice's origin is rounded in double: below 2^-49 edges, for the brick has eight edges at
///  most.
///    Squares that underflow hide less than 2^-56 edges, and a unit is never below 2^-56.
/// So with scan_error = 256u, scan_share = 2^-13 and scan_floor = 2^-47
///     |estimate - d| <= (scan_error estimate + scan_share D + scan_floor) / 2,
/// where d on the right side has been replaced by the estimate at the cost of what is left of the half.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cdfr/core/types.h"
#include "geometry/triangle_group.h"

namespace cdfr {

inline constexpr float scan_error = 256 * 0x1p-24F;
inline constexpr float scan_share = 0x1p-13F;
inline constexpr float scan_floor = 0x1p-47F;

/// Four cache lines; each row lies where a vector can be loaded from.
struct alignas(64) ScanGroup {
  float normals[3][group_size];             ///< unit vectors, or zero where the area is zero; [axis][lane]
  std::int16_t vertices[3][3][group_size];  ///< [corner][axis][lane], in units from the origin
  float origin[3];                          ///< in edges from the lattice's origin
  float unit;                               ///< in edges

  float reach() const noexcept { return 2 * 1.7320509F * 32767 * unit; }
};
static_assert(sizeof(ScanGroup) == 256);

inline void prefetch(const ScanGroup& group) noexcept {
  for (std::size_t line = 0; line < sizeof(ScanGroup); line += 64) {
    __builtin_prefetch(reinterpret_cast<const char*>(&group) + line);
  }
}

/// The group, for a lattice of that origin and edge, a power of two.
ScanGroup scan_group(const TriangleGroup& group, const Vec3& origin, double edge) noexcept;

}  // namespace cdfr
