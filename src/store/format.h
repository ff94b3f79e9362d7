/// Layout of a .cdfr file, version 6.
///
/// All numbers are little endian. A head of 64 bytes and a directory, then sections one after another, each
/// beginning on a multiple of 128 bytes and zero padded to the next one: the arrays of a field as they lie in
/// memory, so that a file is read by mapping it. Section i holds counts[i] elements of element_size[i] bytes.
///
/// | bytes | head |
/// | --- | --- |
/// | 0-7 | magic "cdfr\r\n\x1a\n" |
/// | 8-11 | version, 6 |
/// | 12-15 | number of sections |
/// | 16-23 | size of the whole file; if compressed, of what it unpacks to |
/// | 24-27 | packing: 0 none, 1 zstd |
/// | 28-31 | zero |
/// | 32-39 | XXH64 of the directory |
/// | 40-47 | XXH64 of bytes 0 to 39 |
/// | 48-63 | zero |
///
/// The directory is one 64-bit count a section, in the order of enum Section. The last section, `checksums`,
/// has an XXH64 for each GuardedMap::block_size bytes of the file up to where it begins, head and directory
/// included, the last block being shorter. So a block is checked when it is first read, and no others.
///
/// A packed file has after its head one 64-bit size for each block of GuardedMap::block_size bytes of the
/// file that it was made of, the last one shorter, then an XXH64 of these sizes, then the blocks, each a zstd
/// frame of that size. The first block unpacks to a head that says packing 0, and all of it to a file as
/// above.
///
/// Versions 1 to 5 are not read: they were never in a release.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cdfr/mesh/audit.h"
#include "field/leaf_winding.h"
#include "field/winding.h"
#include "geometry/scan_group.h"
#include "mesh/bvh.h"
#include "mesh/triangles.h"
#include "octree/blocks.h"
#include "octree/leaf_index.h"

namespace cdfr::format {

inline constexpr std::array<char, 8> magic{'c', 'd', 'f', 'r', '\r', '\n', '\x1a', '\n'};
inline constexpr std::uint32_t version = 6;
inline constexpr std::size_t alignment = 128;

enum Section : std::size_t {
  settings,          ///< one Settings
  unit,              ///< characters of the unit's label
  report,            ///< one MeshReport
  levels,            ///< Level, from level 0 on
  top,               ///< TreeNode
  block_starts,      ///< BlockStart
  index_grid,        ///< TreeNode
  index_nodes,       ///< TreeNode
  index_leaves,      ///< LeafIndex::Leaf
  entries,           ///< Entry, of all blocks in order
  scan_groups,       ///< ScanGroup
  triangles,         ///< ExactTriangle, by slot
  records,           ///< TriangleRecord, by slot
  bvh_nodes,         ///< BvhNode
  edge_normals,      ///< Vec3
  vertex_normals,    ///< Vec3
  block_nodes,       ///< TreeNode, of all blocks in order
  block_leaves,      ///< LeafRecord
  windings,          ///< std::int32_t, by leaf
  winding_places,    ///< std::uint32_t, by leaf
  known_windings,    ///< LeafWindings::Known
  near_edges,        ///< std::uint32_t
  winding_nodes,     ///< WindingMoments, by BVH node
  boundary_edges,    ///< BoundaryEdge
  boundary_first,    ///< std::uint32_t, by group
  boundary_lengths,  ///< double, by BVH node
  checksums,         ///< std::uint64_t
  section_count
};

inline constexpr std::array<const char*, section_count> section_name{
    "settings",         "unit",        "report",        "levels",         "top",
    "block_starts",     "index_grid",  "index_nodes",   "index_leaves",   "entries",
    "scan_groups",      "triangles",   "records",       "bvh_nodes",      "edge_normals",
    "vertex_normals",   "block_nodes", "block_leaves",  "windings",       "winding_places",
    "known_windings",   "near_edges",  "winding_nodes", "boundary_edges", "boundary_first",
    "boundary_lengths", "checksums"};

struct Head {
  std::array<char, 8> magic{};
  std::uint32_t version = 0;
  std::uint32_t sections = 0;
  std::uint64_t file_size = 0;
  std::uint32_t packing = 0;
  std::uint32_t zero = 0;
  std::uint64_t directory_hash = 0;
  std::uint64_t hash = 0;
  std::array<std::uint64_t, 2> zeros{};
};
static_assert(sizeof(Head) == 64);
inline constexpr std::size_t hashed_head = 40;

struct Settings {
  double origin[3]{};
  double edge = 0;
  std::uint32_t bricks[3]{};
  std::uint32_t max_triangles_per_leaf = 0;
  double margin = 0;
  double gain = 0;
  double band = 0;
  std::uint32_t max_level = 0;
  std::uint32_t index_level = 0;  ///< LeafIndex::Tables::grid_level
  std::uint8_t sign = 0;          ///< enum Sign: what was chosen
  std::uint8_t sign_option = 0;   ///< enum Sign: what was asked for
  std::uint8_t lists = 0;         ///< enum Lists
  std::uint8_t domain = 0;        ///< enum Domain
  std::uint32_t zero = 0;
};
static_assert(sizeof(Settings) == 88);
static_assert(sizeof(MeshReport) == 160);

/// Of LevelStats, what is not worked out anew.
struct Level {
  std::uint64_t cells = 0, leaves = 0;
  std::uint64_t entries_in = 0, entries_pruned = 0, entries_kept = 0;
};

using Counts = std::array<std::uint64_t, section_count>;

/// Bytes an element of each section takes.
inline constexpr Counts element_size{sizeof(Settings),
                                     1,
                                     sizeof(MeshReport),
                                     sizeof(Level),
                                     sizeof(TreeNode),
                                     sizeof(BlockStart),
                                     sizeof(TreeNode),
                                     sizeof(TreeNode),
                                     sizeof(LeafIndex::Leaf),
                                     sizeof(Entry),
                                     sizeof(ScanGroup),
                                     sizeof(ExactTriangle),
                                     sizeof(TriangleRecord),
                                     sizeof(BvhNode),
                                     sizeof(Vec3),
                                     sizeof(Vec3),
                                     sizeof(TreeNode),
                                     sizeof(LeafRecord),
                                     sizeof(std::int32_t),
                                     sizeof(std::uint32_t),
                                     sizeof(LeafWindings::Known),
                                     sizeof(std::uint32_t),
                                     sizeof(WindingMoments),
                                     sizeof(BoundaryEdge),
                                     sizeof(std::uint32_t),
                                     sizeof(double),
                                     sizeof(std::uint64_t)};

constexpr std::uint64_t aligned(std::uint64_t size) noexcept {
  return (size + alignment - 1) / alignment * alignment;
}

inline constexpr std::uint64_t first_section = aligned(sizeof(Head) + sizeof(Counts));

/// Where each section begins, and where the file ends.
struct Places {
  std::array<std::uint64_t, section_count + 1> at{};

  /// Precondition: counts are small enough that nothing overflows; a reader checks that first.
  constexpr explicit Places(const Counts& counts) noexcept {
    std::uint64_t place = first_section;
    for (std::size_t i = 0; i < section_count; ++i) {
      at[i] = place;
      place += aligned(counts[i] * element_size[i]);
    }
    at[section_count] = place;
  }
  constexpr std::uint64_t file_size() const noexcept { return at[section_count]; }
};

}  // namespace cdfr::format
