#include "cdfr/contour/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "contour/cell_fan.h"
#include "contour/conforming.h"
#include "contour/crossings.h"
#include "contour/sought.h"
#include "contour/surface_lattice.h"
#include "contour/surface_leaves.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Of the tolerance: how far the distance may be below and above linear in a coarse cell, and from several
/// planes that meet sharply. Above counts for less: it is how far round parts bend away from a tangent in the
/// cell's middle, and the mesh has vertices on the contour all about.
constexpr double share_below = 1.0 / 4, share_above = 1.0 / 2, share_sharp = 1.0 / 8;
/// Rounds in which cells that a check found loose are split.
constexpr int most_checks = 4;
constexpr double share_of_descent = 0.6;
constexpr std::size_t most_places = 10000;

class Meshing {
 public:
  Meshing(const Sought& sought, const SurfaceLattice& lattice, Progress& progress)
      : sought_(sought),
        progress_(progress),
        leaves_(sought, lattice),
        crossings_(sought, leaves_.corners()),
        conforming_(leaves_, crossings_) {}

  Result<ContourMesh> run() {
    progress_.phase(0, share_of_descent, leaves_.octree().lattice().deepest + 1);
    if (!leaves_.descend(progress_)) return failure();
    double done = share_of_descent;
    for (int check = 0;; ++check) {
      progress_.phase(done, (done + 1) / 2, 1);
      done = (done + 1) / 2;
      if (!conforming_.run(progress_) || !crossings_.solve(progress_)) return failure();
      fans_.emplace(sought_, leaves_, crossings_, conforming_);
      if (!fans_->place(progress_)) return failure();
      progress_.step();
      if (fans_->loose().empty() || check == most_checks) break;
      if (!leaves_.split(fans_->loose(), progress_)) return failure();
    }
    if (fans_->too_large()) return too_large();
    ContourMesh result{fans_->mesh(), {}};
    describe(result);
    return result;
  }

 private:
  static Error too_large() {
    return {Code::out_of_range, 0, "the mesh would have more than 2^32 - 2 triangles or cells"};
  }
  Error failure() const { return leaves_.octree().overflowed() ? too_large() : Progress::error(); }

  void describe(ContourMesh& result) const {
    ContourMeshReport& report = result.report;
    report.smallest_cell = leaves_.octree().lattice().step;
    report.largest_error = fans_->largest_error();
    report.evaluations = leaves_.octree().evaluations() + leaves_.corners().evaluations() +
                         crossings_.evaluations() + fans_->evaluations();
    const auto& leaves = leaves_.leaves();
    for (std::uint32_t i = 0; i < leaves.size(); ++i) {
      if (!leaves[i].live) continue;
      const std::size_t starts = conforming_.loops(i).size();
      report.cells += starts > 0;
      if (starts > 2) add(report, leaves[i], ContourDoubt::crowded, report.crowded);
      if (leaves[i].undecided && !seen(i)) add(report, leaves[i], ContourDoubt::undecided, report.undecided);
    }
    for (const std::uint32_t leaf : fans_->loose())
      add(report, leaves[leaf], ContourDoubt::loose, report.loose);
  }

  void add(ContourMeshReport& report, const SurfaceLeaf& leaf, ContourDoubt doubt,
           std::uint64_t& count) const {
    const SurfaceCell& cell = leaves_.octree().cell(leaf.cell);
    const SurfaceLattice& lattice = leaves_.octree().lattice();
    if (count++ < most_places)
      report.places.push_back({lattice.centre(cell.lo, cell.level), lattice.size(cell.level), doubt});
  }

  /// Does the mesh pass close by, so that what may be in the leaf is near it?
  bool seen(std::uint32_t number) const {
    if (!conforming_.loops(number).empty()) return true;
    const SurfaceCell& cell = leaves_.octree().cell(leaves_.leaves()[number].cell);
    const SurfaceLattice& lattice = leaves_.octree().lattice();
    if (cell.level < lattice.finest()) return false;
    const auto reach = static_cast<std::int64_t>(0.4 * sought_.tolerance / lattice.step);
    const std::int64_t half = lattice.width(cell.level) / 2;
    for (int direction = 0; direction < 27; ++direction) {
      const std::array<std::int64_t, 3> step{direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1};
      GridPlace place{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t at = std::int64_t{cell.lo[axis]} + half + step[axis] * reach;
        place[axis] = static_cast<std::uint32_t>(std::clamp<std::int64_t>(at, 0, lattice.width(0) - 1));
      }
      const std::uint32_t leaf = leaf_at(place);
      if (leaf != no_index && !conforming_.loops(leaf).empty()) return true;
    }
    return false;
  }

  std::uint32_t leaf_at(const GridPlace& place) const {
    std::uint32_t at = 0;
    for (;;) {
      const SurfaceCell& cell = leaves_.octree().cell(at);
      if (cell.state != CellState::inner) return cell.state == CellState::active ? cell.leaf : no_index;
      const int shift = leaves_.octree().lattice().deepest - cell.level - 1;
      std::uint32_t child = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) child |= (place[axis] >> shift & 1U) << axis;
      at = cell.first_child + child;
    }
  }

  const Sought& sought_;
  Progress& progress_;
  SurfaceLeaves leaves_;
  Crossings crossings_;
  Conforming conforming_;
  std::optional<CellFans> fans_;
};

/// The part's triangles in the order of the input, vertices by first use.
ContourMesh own_surface(const FieldData& field) {
  ContourMesh result;
  std::vector<std::uint32_t> slots(field.triangles.size());
  for (std::uint32_t slot = 0; slot < slots.size(); ++slot)
    slots[field.triangles.records[slot].number] = slot;
  std::vector<std::uint32_t> known(field.report.vertices, no_index);
  for (const std::uint32_t slot : slots) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& vertex = known[field.triangles.records[slot].vertices[k]];
      if (vertex == no_index) {
        vertex = static_cast<std::uint32_t>(result.mesh.vertices.size());
        result.mesh.vertices.push_back(field.triangles.shape(slot).vertices[k]);
      }
      triangle[k] = vertex;
    }
    result.mesh.triangles.push_back(triangle);
  }
  result.report.part_itself = true;
  return result;
}

void count(ContourMesh& result, double tolerance) {
  ContourMeshReport& report = result.report;
  report.tolerance = tolerance;
  report.vertices = result.mesh.vertices.size();
  report.triangles = result.mesh.triangles.size();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  report.box = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Vec3& v : result.mesh.vertices) report.box = united(report.box, {v, v});
}

Sought sought_of(const FieldData& field, const SurfaceLattice& lattice, double distance, double tolerance) {
  const double largest =
      std::max({largest_magnitude(lattice.corner({0, 0, 0})),
                largest_magnitude(lattice.corner({lattice.width(0), lattice.width(0), lattice.width(0)}))});
  return {field,
          distance,
          tolerance,
          {share_below * tolerance, share_above * tolerance, share_sharp * tolerance},
          point_rounding(largest)};
}

Result<void> check_options(const FieldData& field, double distance, double tolerance) {
  if (!std::isfinite(distance)) return Error{Code::bad_option, 0, "distance must be finite"};
  if (tolerance == 0) return Error{Code::bad_option, 0, "a mesh of no size needs a tolerance"};
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    return Error{Code::bad_option, 0, "tolerance must be positive"};
  if (field.sign == Sign::none && !(distance > 0)) {
    return Error{Code::not_closed, 0,
                 "an unsigned field has no inside: a surface lies at distances above 0 only"};
  }
  if (!field.winding.empty()) {
    return Error{Code::not_closed, 0,
                 "the mesh is open, so that no closed surface has this signed distance; an unsigned field "
                 "(--sign none) "
                 "has one at any distance above 0"};
  }
  return {};
}

}  // namespace

Result<ContourMesh> contour_mesh(const Field& field, double distance, const ContourMeshOptions& options,
                                 const Run& run) {
  const FloatingEnvironment environment;
  const FieldData& data = field.data();
  const double tolerance = options.tolerance == 0 ? longest_side(data.bounds()) / 1000 : options.tolerance;
  if (const Result<void> checked = check_options(data, distance, tolerance); !checked) return checked.error();
  const SurfaceLattice lattice = surface_lattice(data.bounds(), std::fabs(distance), tolerance);
  if (!fits(lattice)) {
    return Error{Code::bad_option, 0,
                 "tolerance must be at least 2^-15 of the contour's box and 2^-26 of the largest coordinate"};
  }
  Progress progress(run);
  progress.watch(data.map.get());
  Result<ContourMesh> result = Progress::error();
  with_threads(run, [&] {
    if (distance == 0 && data.report.embedded() && data.report.degenerate_triangles == 0) {
      if (progress.poll()) result = own_surface(data);
    } else {
      const Sought sought = sought_of(data, lattice, distance, tolerance);
      result = Meshing(sought, lattice, progress).run();
    }
  });
  if (data.failed()) return data.status().error();
  if (result) count(*result, tolerance);
  return result;
}

}  // namespace cdfr
