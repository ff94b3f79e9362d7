/// The source paper's own field, as it stands there: a uniform grid of voxels with lists that spread to
/// neighbours. A second oracle for the octree and a yardstick for tables; not the way to measure parts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/core/types.h"
#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"
#include "cdfr/octree/leaf.h"

namespace cdfr {

/// papers/huang-2001, section 3.2: a triangle and its distance from a voxel's centre.
struct CddTuple {
  double distance = 0;
  std::uint32_t triangle = no_index;
  friend bool operator==(const CddTuple&, const CddTuple&) = default;
};

/// What a voxel is, and which ones are surface voxels.
enum class UniformVoxels : std::uint8_t {
  /// The space between eight points of the lattice; a surface voxel is one that a triangle touches.
  cells,
  /// The space around a point of the lattice, on which the lowest corner of the mesh's box lies. A surface
  /// voxel's point is at most a voxel away from a triangle and not outside by the paper's sign; the triangles
  /// as near as that are its list. The counts of inner voxels in the paper's tables show it
  /// (papers/huang-2001/README.md). Beside the surface, where voxels are dropped that reach inside, lists are
  /// not complete; of a mesh turned inside out nothing is left to list.
  points,
};

struct UniformOptions {
  /// Voxels along the longest side of the mesh's box, 1 to 65536.
  int resolution = 32;
  /// Layers of voxels around that box, 1 to 64.
  int border = 1;
  /// The paper drops the voxels that the flood reaches; true gives them lists as well.
  bool keep_outside = false;
  /// The paper's text lets every voxel that is kept take over from its neighbours; false leaves a surface
  /// voxel with the triangles that made it one, which is incomplete.
  bool surface_inherits = true;
  UniformVoxels voxels = UniformVoxels::cells;
};

/// Most voxels of a grid (about 50 bytes each), and most tuples of all lists together after a round (16
/// bytes).
inline constexpr std::uint64_t most_uniform_cells = std::uint64_t{1} << 27;
inline constexpr std::uint64_t most_uniform_tuples = std::uint64_t{1} << 27;

struct UniformStats {
  std::uint64_t inside_cells = 0, surface_cells = 0, outside_cells = 0;
  std::uint64_t inside_tuples = 0, surface_tuples = 0, outside_tuples = 0;
  std::uint64_t rounds = 0;        ///< of the propagation, until no list changed
  std::uint64_t measured = 0;      ///< distances computed by it
  std::uint64_t stated_bytes = 0;  ///< by the paper's count: 4 n + 5 a voxel with a list of n, 1 without
};

struct UniformClosest {
  double distance = 0;                ///< signed by the base triangle, negative inside; NaN without a list
  std::uint32_t triangle = no_index;  ///< closest; ties to the lowest number
  std::uint32_t base = no_index;      ///< the paper's base triangle, whose normal gives the sign
  Feature feature = Feature::face;    ///< C1 face, C2 edge, C3 vertex
  Vec3 normal;  ///< section 3.6: base triangle's normal, or from the surface to the point
};

struct UniformData;

/// Immutable; copies share; any number of threads may query it.
class CDFR_API UniformField {
 public:
  /// Errors: those of audit; bad_option (named: resolution, border, more voxels than most_uniform_cells, a
  /// mesh of no size), out_of_range (voxels below rounding, too many tuples), cancelled. Same bits for any
  /// number of threads.
  static Result<UniformField> build(MeshView mesh, const UniformOptions& options = {}, const Run& run = {});

  /// Voxels along each axis. Cell numbers run along x first, then y, then z.
  std::array<int, 3> counts() const noexcept;
  std::size_t cell_count() const noexcept;
  /// Edge of a voxel.
  double voxel() const noexcept;
  /// Precondition of what follows: cell < cell_count(). Surface: as UniformVoxels has it; outside: the flood
  /// reached it, or it would be a surface voxel but for its sign; inside: all others, shut cavities included.
  Side side(std::size_t cell) const noexcept;
  Box box(std::size_t cell) const noexcept;
  /// Ascending by distance, then number; empty for a voxel that was dropped.
  std::span<const CddTuple> list(std::size_t cell) const noexcept;
  /// The voxel of x, half open; nothing beyond the grid or if x is not finite.
  std::optional<std::size_t> locate(Vec3 x) const noexcept;

  /// From the list of the voxel of x and nothing else.
  UniformClosest closest(Vec3 x) const noexcept;
  double distance(Vec3 x) const noexcept { return closest(x).distance; }

  UniformOptions options() const noexcept;
  /// O(cells).
  UniformStats stats() const noexcept;

  /// For the rooms of the library.
  const UniformData& data() const noexcept { return *data_; }
  explicit UniformField(std::shared_ptr<const UniformData> data) noexcept : data_(std::move(data)) {}

 private:
  std::shared_ptr<const UniformData> data_;
};

}  // namespace cdfr
