/// The octree's active leaves with the signs at their corners, refined until each leaf's own corners show the
/// contour in it simply.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contour/cell_faces.h"
#include "contour/corner_values.h"
#include "contour/surface_octree.h"
#include "core/progress.h"

namespace cdfr {

struct SurfaceLeaf {
  std::uint32_t cell = 0;
  std::array<std::uint32_t, 8> corners{};         ///< numbers in CornerValues
  std::array<std::uint32_t, cell_sides> sides{};  ///< crossing on a side, or no_index
  std::uint8_t held = 0;                          ///< bit k: the set holds corner k
  bool undecided = false;                         ///< the contour may pass, and no corner shows it
  bool live = true;                               ///< false once it was split or found empty
};

class SurfaceLeaves {
 public:
  SurfaceLeaves(const Sought& sought, const SurfaceLattice& lattice);

  SurfaceOctree& octree() noexcept { return octree_; }
  const SurfaceOctree& octree() const noexcept { return octree_; }
  const CornerValues& corners() const noexcept { return corners_; }
  std::vector<SurfaceLeaf>& leaves() noexcept { return leaves_; }
  const std::vector<SurfaceLeaf>& leaves() const noexcept { return leaves_; }
  int level(const SurfaceLeaf& leaf) const noexcept { return octree_.cell(leaf.cell).level; }

  /// Both return false if cancelled or if the octree has overflowed.
  bool descend(Progress& progress);
  /// Precondition: none of them is at the deepest level.
  bool split(std::span<const std::uint32_t> leaves, Progress& progress);

 private:
  enum class Verdict : std::uint8_t { keep, undecided, empty, split };

  bool settle(std::vector<std::uint32_t> cells, Progress& progress);
  void add(std::uint32_t cell);
  Verdict judge(const SurfaceLeaf& leaf, std::vector<NearTriangle>& near) const;
  Verdict judge_hidden(const SurfaceLeaf& leaf, std::vector<NearTriangle>& near) const;

  const Sought& sought_;
  SurfaceOctree octree_;
  CornerValues corners_;
  std::vector<SurfaceLeaf> leaves_;
};

}  // namespace cdfr
