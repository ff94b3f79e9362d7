/// Eight triangles side by side in single precision: half the cache lines of a TriangleGroup, and twice the
/// lanes. A query looks through these first; what may be closest by them is measured in double-double.
///
/// Coordinates are in units of the lattice's edge and relative to the group's origin, so that what rounding
/// does goes with the size of the group and with the distance from it, not with the size of the mesh.
///
/// **Bound.** Let u = 2^-24, D the group's reach (twice the largest |v - origin|, so no two of its points are
/// farther apart) and d the distance from p to one of its triangles; every vertex is within d + D of p, and p
/// within d + D/2 of the origin... so that rounding p and the vertices to single precision moves them by at
/// most u (d + D) and u D. The estimate's own arithmetic is triangle_group.h's with this u: 98u (d + D); here
/// |e| |r| stands for |e|_1 |r|_1 and products may be fused, which lowers errors. Differences to the
/// lattice's origin are rounded in double before: below 2^-49 edges, for the brick has eight edges at most.
/// Squares that underflow hide less than 2^-60 edges. With scan_error = 256u and scan_floor = 2^-47 therefore
///     |estimate - d| <= scan_error (d + D) / 2 + scan_floor / 2,
/// and as d <= 2 estimate + D + scan_floor the same holds with scan_error (estimate + D) + scan_floor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"
#include "geometry/triangle_group.h"

namespace cdfr {

inline constexpr float scan_error = 256 * 0x1p-24F;
inline constexpr float scan_floor = 0x1p-47F;

/// Seven cache lines, the last one half full.
struct alignas(64) ScanGroup {
  float vertices[3][3][group_size];  ///< [corner][axis][lane]
  float normals[3][group_size];      ///< unit, or zero where the area is zero; [axis][lane]
  float origin[3];                   ///< in edges from the lattice's origin
  float reach;                       ///< D, rounded up
};

inline void prefetch(const ScanGroup& group) noexcept {
  for (std::size_t line = 0; line < sizeof(ScanGroup); line += 64) {
    __builtin_prefetch(reinterpret_cast<const char*>(&group) + line);
  }
}

/// The group in units of `edge` from `origin`.
ScanGroup scan_group(const TriangleGroup& group, const Vec3& origin, double edge) noexcept;

}  // namespace cdfr
