/// Looks through a leaf's list in single precision for the triangles that may be closest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/scan_group.h"
#include "mesh/bvh.h"
#include "octree/leaf_index.h"

namespace cdfr {

/// What a list says of a point before any of its groups is read.
struct Shortlist {
  /// Entries that it covers; a longer list goes on beyond it.
  static constexpr std::size_t most = 64;
  /// Lower bounds (entry_bound.h) on the squared distances, in edges, as scan.cpp has them.
  alignas(64) std::array<float, most> squared;
  /// The two of least bound; equal if there is one only.
  std::uint32_t first, second;
};

/// The mesh as a scan reads it.
struct ScanSpace {
  const TriangleStore& triangles;
  const ScanGroup* groups;
  const Bvh& bvh;
  const Lattice& lattice;
};

/// The list's beginning, or nothing of it if it is empty. Calls for the groups that are read first.
void shorten(const ScanGroup* groups, const Located& leaf, Shortlist& shortlist) noexcept;

/// Triangles that a scan has not ruled out, by slot.
struct Candidates {
  static constexpr std::uint32_t most = 64;
  /// A scan writes whole vectors.
  static constexpr std::uint32_t room = most + 2 * group_size + 16;
  std::array<std::uint32_t, room> slots;
  std::array<float, room> squared;  ///< estimated, in edges
  std::uint32_t count;              ///< of the above that are set
  float upper;                      ///< bound on the least distance, in edges
  /// None is missing. Else more triangles are about equally close than there is room for, or the point is too
  /// far away to tell them apart, and a search in double answers (search.h).
  bool complete;
};

/// Fills `candidates` with every triangle of the list whose computed distance from the point is least, or is
/// as small but for rounding, and with few others. `at` is p in edges from the lattice's origin, and
/// `shortlist` is the leaf's for it.
///
/// The group whose lower bound is least comes first: it most often brings the upper bound U on the least
/// distance close to what it will be. Then only entries whose own bound is within U are read, in the order of
/// the list. It ascends, so it ends where an entry's distance from the centre exceeds the point's own by more
/// than U. With scan_group.h's bound, an estimate e in a group of reach D
/// says U <= (e + s D + f)(1 + 2k), k = scan_error, s = scan_share, f = scan_floor, and rules its triangle
/// out if e > (U + s D + f)(1 + 2k): then its true distance is above U. The unused half of the bound covers
/// the roundings of U and of that threshold, and with 2^-48 edges what separates computed distances that tie
/// (2^-88 of the largest coordinate, below 2^-54 edges). Which others come along differs with the instruction
/// set; they lose in double-double, so answers do not.
void scan(const ScanSpace& space, const Vec3& p, const Vec3& at, const Located& leaf,
          const Shortlist& shortlist, Candidates& candidates) noexcept;

/// The same for all of the mesh, for a point that may lie outside the brick: p rounds by 2^-53 of its
/// distance more, which is within the bound's share of that.
void scan(const ScanSpace& space, const Vec3& p, Candidates& candidates) noexcept;

}  // namespace cdfr
