/// The octree whose leaves hold a contour's mesh: coarse where the distance is close to few linear functions,
/// fine elsewhere. It knows the mesh's triangles around each cell but nothing of signs at corners.
///
/// A cell that the contour cannot pass is a leaf without mesh (`empty`): its distance has one side
/// throughout. Proofs: |d(c) - D| > half diagonal, for the distance has slope 1, or bounds by tangents and
/// corners (flatness.h).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contour/flatness.h"
#include "field/near_triangles.h"
#include "contour/sought.h"
#include "contour/surface_lattice.h"
#include "core/progress.h"

namespace cdfr {

enum class CellState : std::uint8_t { fresh, inner, empty, active };

struct SurfaceCell {
  static constexpr std::uint32_t no_list = 0xffffffffU;

  GridPlace lo{};
  std::uint8_t level = 0;
  CellState state = CellState::fresh;
  std::uint8_t planes = 0;  ///< of flatness.h; 0 where it was not tried or failed
  bool surface_enters = false;
  bool busy = false;  ///< an active leaf, or inner and was made above one
  std::uint32_t parent = no_index;
  std::uint32_t first_child = 0;  ///< of an inner cell, in child order
  std::uint32_t leaf = no_index;  ///< of an active cell: its number there
  /// Triangles that may win in the cell: slots in `lists`, or no_list where none was made.
  std::uint32_t list = no_list, list_size = 0;
};

class SurfaceOctree {
 public:
  SurfaceOctree(const Sought& sought, const SurfaceLattice& lattice);

  const std::vector<SurfaceCell>& cells() const noexcept { return cells_; }
  const SurfaceCell& cell(std::uint32_t number) const noexcept { return cells_[number]; }
  SurfaceCell& cell(std::uint32_t number) noexcept { return cells_[number]; }
  const SurfaceLattice& lattice() const noexcept { return lattice_; }
  std::uint64_t evaluations() const noexcept { return evaluations_; }

  /// There are more cells than numbers for them: what was returned since is not all.
  bool overflowed() const noexcept { return overflowed_; }

  /// From the root down to leaves. The new active leaves, level by level, in the order of their parents.
  /// Empty if cancelled.
  std::vector<std::uint32_t> descend(Progress& progress);
  /// Splits active leaves above the deepest level, down to leaves again. The new active ones.
  std::vector<std::uint32_t> split(std::span<const std::uint32_t> leaves, Progress& progress);

  /// The triangles that may win in an active leaf, by its list or from the mesh; false if they are too many.
  bool near(const SurfaceCell& cell, std::vector<NearTriangle>& near) const;

 private:
  struct Outcome;
  struct Task;
  void add_children(std::uint32_t parent, std::vector<std::uint32_t>& frontier);
  bool find_near(const SurfaceCell& cell, const Eigen::Vector3d& centre, double distance,
                 std::vector<NearTriangle>& near) const;
  void judge_sheet(const Vec3& centre, double size, const std::vector<NearTriangle>& near,
                   Outcome& outcome) const;
  void judge(const SurfaceCell& cell, double value, std::vector<NearTriangle>& near, Outcome& outcome) const;
  void judge_some(std::span<const std::uint32_t> some, Task& task, Progress& progress) const;
  std::vector<std::uint32_t> judge_all(std::span<const std::uint32_t> frontier,
                                       std::vector<std::uint32_t>& active, Progress& progress);
  void apply(std::uint32_t number, const Outcome& outcome, std::size_t list,
             std::vector<std::uint32_t>& active, std::vector<std::uint32_t>& next);

  const Sought& sought_;
  SurfaceLattice lattice_;
  std::vector<SurfaceCell> cells_;
  std::vector<std::uint32_t> lists_;
  std::uint64_t evaluations_ = 0;
  bool overflowed_ = false;
};

}  // namespace cdfr
