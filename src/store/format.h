/// Layout of a .cdfr file, version 4.
///
/// All numbers are little endian. A head of 64 bytes, then sections one after another, each beginning on a
/// multiple of 64 bytes: section i holds counts[i] elements of the size below, zero padded to the next
/// multiple of 64. After the last section comes one XXH64 of all bytes before it.
///
/// | bytes | head |
/// | --- | --- |
/// | 0-7 | magic "cdfr\r\n\x1a\n" |
/// | 8-11 | version, 4 |
/// | 12-15 | number of sections |
/// | 16-23 | size of the whole file |
/// | 24-63 | zero |
///
/// The first section, `counts`, has one 64-bit count a section, itself included. The others are the arrays of
/// FieldData byte for byte, in the order of enum Section. Blocks are concatenated; `block_sizes` tells where
/// each ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cdfr/mesh/audit.h"
#include "mesh/bvh.h"
#include "mesh/triangles.h"
#include "octree/blocks.h"

namespace cdfr::format {

inline constexpr std::array<char, 8> magic{'c', 'd', 'f', 'r', '\r', '\n', '\x1a', '\n'};
inline constexpr std::uint32_t version = 4;
inline constexpr std::size_t alignment = 64;

enum Section : std::size_t {
  counts,
  settings,        ///< one Settings
  unit,            ///< characters of the unit's label
  report,          ///< one MeshReport
  triangles,       ///< ExactTriangle
  records,         ///< TriangleRecord
  bvh_nodes,       ///< BvhNode
  edge_normals,    ///< Vec3
  vertex_normals,  ///< Vec3
  top,             ///< TreeNode
  block_sizes,     ///< BlockSize
  block_nodes,     ///< TreeNode
  block_leaves,    ///< LeafRecord
  block_entries,   ///< Entry
  levels,          ///< LevelStats
  section_count
};

using Counts = std::array<std::uint64_t, section_count>;

/// Bytes an element of each section takes.
inline constexpr std::array<std::uint64_t, section_count> element_size{sizeof(std::uint64_t),
                                                                       72,
                                                                       1,
                                                                       sizeof(MeshReport),
                                                                       sizeof(ExactTriangle),
                                                                       sizeof(TriangleRecord),
                                                                       sizeof(BvhNode),
                                                                       sizeof(Vec3),
                                                                       sizeof(Vec3),
                                                                       sizeof(TreeNode),
                                                                       32,
                                                                       sizeof(TreeNode),
                                                                       sizeof(LeafRecord),
                                                                       sizeof(Entry),
                                                                       sizeof(LevelStats)};

/// Bytes a section of that size takes.
constexpr std::uint64_t padded(std::uint64_t size) noexcept {
  return (size + alignment - 1) / alignment * alignment;
}

/// Precondition: counts are small enough that no product overflows; a reader checks that first.
constexpr std::uint64_t file_size(const Counts& counts) noexcept {
  std::uint64_t size = 64;
  for (std::size_t i = 0; i < section_count; ++i) size += padded(counts[i] * element_size[i]);
  return size + sizeof(std::uint64_t);
}

struct Head {
  std::array<char, 8> magic{};
  std::uint32_t version = 0;
  std::uint32_t sections = 0;
  std::uint64_t file_size = 0;
  std::array<std::uint64_t, 5> zero{};
};
static_assert(sizeof(Head) == 64);

struct Settings {
  double origin[3]{};
  double edge = 0;
  std::uint32_t bricks[3]{};
  std::uint32_t max_triangles_per_leaf = 0;
  double margin = 0;
  double gain = 0;
  std::uint32_t max_level = 0;
  std::uint8_t sign = 0;         ///< enum Sign: what was chosen
  std::uint8_t sign_option = 0;  ///< enum Sign: what was asked for
  std::uint8_t lists = 0;        ///< enum Lists
  std::uint8_t zero = 0;
};
static_assert(sizeof(Settings) == 72);
static_assert(sizeof(MeshReport) == 160);

struct BlockSize {
  std::uint64_t key = 0;
  std::uint64_t nodes = 0;
  std::uint64_t leaves = 0;
  std::uint64_t entries = 0;
};
static_assert(sizeof(BlockSize) == 32);

}  // namespace cdfr::format
