/// The complete distance field of a mesh: exact signed distance, closest point, triangle and feature
/// anywhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "cdfr/core/api.h"
#include "cdfr/core/points.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/core/types.h"
#include "cdfr/field/grid.h"
#include "cdfr/mesh/audit.h"
#include "cdfr/mesh/mesh.h"
#include "cdfr/octree/leaf.h"
#include "cdfr/octree/options.h"

namespace cdfr {

/// What a closest point lies on.
enum class Feature : std::uint8_t { face, edge, vertex };

struct Closest {
  double distance = 0;                ///< negative inside; NaN if the query was not finite
  Vec3 point;                         ///< on the surface, to within an ulp of its coordinates
  Vec3 gradient;                      ///< unit, of the signed distance; on the surface the (pseudo)normal
  std::uint32_t triangle = no_index;  ///< base triangle: its number in the input
  std::uint32_t patch = 0;            ///< of that triangle
  Feature feature = Feature::face;
  std::uint8_t element = 0;  ///< edge k joins corners k and (k + 1) % 3; vertex k is corner k; face 0
  std::array<double, 3> barycentric{};  ///< of `point` in the triangle; they add up to 1
};

/// The centre of the largest ball that fits inside, as far as it was asked for.
struct Deepest {
  Vec3 point;        ///< nothing of use if no point inside was found
  double depth = 0;  ///< of the point; 0 if no point inside was found
  double error = 0;  ///< no point is deeper than depth + error
};

/// Leaves that the domain leaves out are not counted, but in `levels`.
struct Stats {
  std::uint64_t triangles = 0, vertices = 0;
  std::uint64_t inside_leaves = 0, surface_leaves = 0, outside_leaves = 0, undecided_leaves = 0;
  std::uint64_t entries = 0;           ///< of all leaves: groups of up to 8 triangles and BVH nodes
  double mean_list = 0, p95_list = 0;  ///< triangles a leaf
  std::uint64_t max_list = 0;
  std::uint64_t bytes = 0;  ///< memory of the whole field, mesh included
  std::vector<LevelStats> levels;
};

struct FieldData;

/// Immutable; copies share; any number of threads may query it. A point's answers never depend on options or
/// threads.
class CDFR_API Field {
 public:
  /// Errors: empty_mesh, bad_index, not_finite, out_of_range, bad_option, cancelled. Copies what it needs of
  /// the mesh. Same bits for any number of threads.
  static Result<Field> build(MeshView mesh, const BuildOptions& options = {}, const Run& run = {});

  /// Signed distance, within 4 ulp of the truth (ulp at the largest absolute coordinate of mesh and query).
  /// NaN if x is not finite. O(1) cells in the domain, O(log n) beyond, O(n)
  /// from 2^45 times the mesh's size on; no allocation.
  double distance(Vec3 x) const noexcept;
  /// Distance with all that belongs to it. Ties in the computed distance go to the lowest triangle number; a
  /// triangle of no area wins only where no proper one is as close.
  Closest closest(Vec3 x) const noexcept;
  /// Batch forms: out[i] belongs to x[i]. Errors: cancelled; status(). Precondition: out.size() == x.size().
  Result<void> distance(Points x, std::span<double> out, const Run& run = {}) const;
  /// The same bits as distance(grid.point(i, j, k)), which neighbouring samples find together. Precondition:
  /// out.size() == grid.count().
  Result<void> distance(const Grid& grid, std::span<double> out, const Run& run = {}) const;
  Result<void> closest(Points x, std::span<Closest> out, const Run& run = {}) const;

  /// The same field with its octree cut at a level, 0 to 18, for pictures and sweeps without a rebuild:
  /// deeper leaves make one of their cell, with all of their triangles, so lists stay complete and answers
  /// the same. Shares all but the octree. Errors: bad_option; status(). O(leaves and their lists).
  Result<Field> at_level(int level) const;

  /// The deepest point inside, to that error in the mesh's unit; 0 takes the longest side / 1000. Errors:
  /// bad_option (not finite, or negative), not_closed (an unsigned field has no inside), cancelled; status().
  /// O(leaves), then some hundred distances as a rule; more the more places are about as deep, and where a
  /// part is thin beside its leaves.
  Result<Deepest> deepest(double error = 0, const Run& run = {}) const;

  /// Of a field from a file: an error if something that was read turned out to be damaged, or the file has
  /// been cut short, changed or replaced since. Damage is for good: from then on every distance is NaN, and
  /// calls that return a Result return this error. Nothing is wrong with a field that was built. One call to
  /// the system.
  Result<void> status() const;

  /// Box that the octree covers: at least the mesh's box grown by the margin.
  Box domain() const noexcept;
  /// Box of the mesh.
  Box bounds() const noexcept;
  /// Never automatic: what was chosen.
  Sign sign() const noexcept;
  /// What the audit found when the field was built.
  const MeshReport& report() const noexcept;
  /// As they were given, but for what was chosen: max_level is never automatic, expected_queries is 0, and
  /// max_triangles_per_leaf what it led to.
  BuildOptions options() const noexcept;
  /// O(leaves).
  Stats stats() const;
  /// One number for the logical leaves in Morton order: the same for any thread count, block cut and round
  /// trip.
  std::uint64_t checksum() const;

  /// Leaves in Morton order, for pictures, solvers and tests; those that the domain leaves out are among
  /// them. Precondition: i < leaf_count(). O(leaves of its block, and its list): for one or a few.
  std::size_t leaf_count() const noexcept;
  Leaf leaf(std::size_t i) const;
  /// All of them one after another, but for those that the domain leaves out. O(leaves and their lists).
  void for_each_leaf(const std::function<void(const Leaf&)>& visit) const;

  /// For the rooms of the library.
  const FieldData& data() const noexcept { return *data_; }
  explicit Field(std::shared_ptr<const FieldData> data) noexcept : data_(std::move(data)) {}

 private:
  std::shared_ptr<const FieldData> data_;
};

/// The oracle: every triangle, no tree. Same bits as Field::closest. O(triangles) a call, after an O(n log n)
/// set-up that is redone each call; BruteForce keeps it. NaN distance for a mesh that Field::build would
/// refuse.
CDFR_API Closest closest_brute(MeshView mesh, Vec3 x, Sign sign = Sign::automatic);

/// closest_brute with its set-up kept. Thread safe after construction.
class CDFR_API BruteForce {
 public:
  static Result<BruteForce> over(MeshView mesh, Sign sign = Sign::automatic);
  Closest closest(Vec3 x) const noexcept;

 private:
  explicit BruteForce(std::shared_ptr<const FieldData> data) noexcept : data_(std::move(data)) {}
  std::shared_ptr<const FieldData> data_;
};

}  // namespace cdfr
