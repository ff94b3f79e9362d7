#include "cdfr/mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/floating_environment.h"
#include "core/progress.h"
#include "geometry/box_distance.h"
#include "geometry/expansion.h"
#include "geometry/vertex_order.h"
#include "mesh/counts.h"
#include "mesh/mesh_fault.h"

namespace cdfr {
namespace {

/// Coordinates are multiples of it: what is nearer than this is at one place.
constexpr double finest_spacing = 0x1p-252;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Exactly: is the distance at most the tolerance? Precondition: the tolerance is 0 or at least
/// finest_spacing, so no product underflows.
bool within(const Vec3& a, const Vec3& b, double tolerance) noexcept {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  const double squared = x * x + y * y + z * z, limit = tolerance * tolerance;
  // Three differences, products and two sums round by less than 6u together, the limit by u.
  if (squared < limit * (1 - 16 * unit_roundoff)) return true;
  if (squared > limit * (1 + 16 * unit_roundoff)) return false;
  const auto ex = exact_difference(a.x, b.x), ey = exact_difference(a.y, b.y),
             ez = exact_difference(a.z, b.z);
  Expansion<1> t;
  t.add(tolerance);
  return (ex * ex + ey * ey + ez * ez - t * t).sign() <= 0;
}

/// The least power of two that is neither below the tolerance nor finest_spacing. Coordinates divided by it
/// are exact, so those that differ by at most the tolerance are in the same or in neighbouring cells.
double cell_side(double tolerance) noexcept {
  double side = finest_spacing;
  int exponent = 0;
  const double fraction = std::frexp(tolerance, &exponent);
  if (tolerance > side) side = std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
  return side;
}

struct Place {
  Vec3 cell, position;
  std::uint32_t vertex = 0;
};

/// Cells are filled one after another, so what is kept in a cell is a range of all that is kept.
struct Cell {
  Vec3 key;
  std::size_t first = 0;  ///< its positions are those from here to the next cell's
  std::size_t first_kept = 0, end_kept = 0;
};

/// Gives for one cell after another, in order, those around it. The cells with keys (i, j, k - 1) to
/// (i, j, k + 1) are a run, and its start moves on with the cell that is asked for: over all cells that is
/// linear. Only beyond 2^53, where k + 1 may be k or k + 2, does it ever move back, and cells of one i twice
/// at most.
class Surroundings {
 public:
  template <class Visit>
  void visit(const std::vector<Cell>& cells, const Cell& cell, Visit visit) {
    for (int run = 0; run < 9; ++run) {
      const Vec3 low{cell.key.x + (run / 3 - 1), cell.key.y + (run % 3 - 1), cell.key.z - 1};
      const Vec3 high{low.x, low.y, cell.key.z + 1};
      std::size_t& start = starts_[run];
      if (start > 0 && !precedes(cells[start - 1].key, low)) start = first_from(cells, low, start);
      while (start < cells.size() && precedes(cells[start].key, low)) ++start;
      for (std::size_t i = start; i < cells.size() && !precedes(high, cells[i].key); ++i) visit(cells[i]);
    }
  }

 private:
  static std::size_t first_from(const std::vector<Cell>& cells, const Vec3& low, std::size_t end) {
    const auto at = std::partition_point(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(end),
                                         [&](const Cell& c) { return precedes(c.key, low); });
    return static_cast<std::size_t>(at - cells.begin());
  }

  std::array<std::size_t, 9> starts_{};
};

/// Where every position goes.
class Gathering {
 public:
  Gathering(const Mesh& mesh, double tolerance) : tolerance_(tolerance < finest_spacing ? 0 : tolerance) {
    sort_into_cells(mesh);
  }

  /// Chooses what is kept. A cell is less than twice the tolerance wide, or holds one position: no more than
  /// 4^3 can be kept in it, so each position is compared with a bounded number, if ever so many are near it.
  void keep() {
    Surroundings around;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      find_candidates(around, cells_[c]);
      cells_[c].first_kept = kept_.size();
      for (std::size_t i = cells_[c].first; i < end_of(c); ++i) {
        const auto is_near = [&](std::size_t k) { return within(positions_[i], positions_[k], tolerance_); };
        if (std::any_of(candidates_.begin(), candidates_.end(), is_near)) continue;
        kept_.push_back(i);
        candidates_.push_back(i);
      }
      cells_[c].end_kept = kept_.size();
    }
  }

  /// Sends each of the others to the nearest kept one.
  void move(WeldReport& report) {
    Surroundings around;
    homes_.resize(positions_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      find_candidates(around, cells_[c]);
      for (std::size_t i = cells_[c].first; i < end_of(c); ++i) {
        homes_[i] = nearest_candidate(positions_[i]);
        if (homes_[i] == i) continue;
        ++report.merged_vertices;
        const double move = distance_between(positions_[i], positions_[homes_[i]]);
        report.largest_move = std::max(report.largest_move, move);
      }
    }
  }

  std::size_t position_count() const noexcept { return positions_.size(); }
  /// Precondition: a triangle uses the vertex. The number of a position.
  std::size_t home_of(std::uint32_t vertex) const noexcept { return homes_[position_of_[vertex]]; }
  const Vec3& position(std::size_t number) const noexcept { return positions_[number]; }

 private:
  std::vector<Place> sorted_places(const Mesh& mesh) const {
    const double side = cell_side(tolerance_);
    const auto cell = [side](double x) { return std::floor(x / side); };
    std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
    for (const Triangle& t : mesh.triangles) used[t[0]] = used[t[1]] = used[t[2]] = 1;
    std::vector<Place> places;
    for (std::uint32_t v = 0; v < used.size(); ++v) {
      if (used[v] == 0) continue;
      const Vec3& p = mesh.vertices[v];
      // Adding zero turns -0 into 0, so that what is kept does not depend on which of them came first.
      places.push_back({{cell(p.x), cell(p.y), cell(p.z)}, {p.x + 0.0, p.y + 0.0, p.z + 0.0}, v});
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return a.cell != b.cell ? precedes(a.cell, b.cell) : precedes(a.position, b.position);
    });
    return places;
  }

  void sort_into_cells(const Mesh& mesh) {
    position_of_.resize(mesh.vertices.size());
    for (const Place& place : sorted_places(mesh)) {
      if (positions_.empty() || positions_.back() != place.position) {
        if (cells_.empty() || cells_.back().key != place.cell)
          cells_.push_back({place.cell, positions_.size()});
        positions_.push_back(place.position);
      }
      position_of_[place.vertex] = static_cast<std::uint32_t>(positions_.size() - 1);
    }
  }

  std::size_t end_of(std::size_t cell) const noexcept {
    return cell + 1 < cells_.size() ? cells_[cell + 1].first : positions_.size();
  }

  void find_candidates(Surroundings& around, const Cell& cell) {
    candidates_.clear();
    around.visit(cells_, cell, [&](const Cell& near) {
      for (std::size_t k = near.first_kept; k < near.end_kept; ++k) candidates_.push_back(kept_[k]);
    });
  }

  /// One is within the tolerance, or the position would have been kept itself.
  std::size_t nearest_candidate(const Vec3& p) const noexcept {
    std::size_t nearest = 0;
    double least = infinity;
    for (const std::size_t k : candidates_) {
      const double distance = distance_between(p, positions_[k]);
      if (distance < least && within(p, positions_[k], tolerance_)) {
        nearest = k;
        least = distance;
      }
    }
    return nearest;
  }

  double tolerance_;
  std::vector<Vec3> positions_;             ///< distinct, by cell, then x, y, z
  std::vector<std::uint32_t> position_of_;  ///< by vertex
  std::vector<Cell> cells_;
  std::vector<std::size_t> kept_;        ///< positions, ascending
  std::vector<std::size_t> homes_;       ///< by position
  std::vector<std::size_t> candidates_;  ///< kept positions around the cell that is looked at
};

std::optional<Error> refused(const Mesh& mesh, double tolerance) {
  if (!(tolerance >= 0 && tolerance < infinity)) {
    return Error{Code::bad_option, 0, "weld tolerance must be 0 or positive, and finite"};
  }
  if (auto fault = mesh_fault(mesh.view())) return fault;
  if (!mesh.patches.empty() && mesh.patches.size() != mesh.triangles.size()) {
    return Error{Code::bad_option, 0, "patches must be one a triangle, or none"};
  }
  if (tolerance > longest_side(box_of(mesh.view())) / 100) {
    return Error{Code::bad_option, 0, "weld tolerance is more than a hundredth of the mesh's longest side"};
  }
  return std::nullopt;
}

void rebuild(const Mesh& mesh, const Gathering& gathering, Welded& welded) {
  std::vector<std::uint32_t> ids(gathering.position_count(), no_index);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::size_t, 3> homes{};
    for (int k = 0; k < 3; ++k) homes[k] = gathering.home_of(mesh.triangles[t][k]);
    if (homes[0] == homes[1] || homes[1] == homes[2] || homes[2] == homes[0]) {
      ++welded.report.collapsed_triangles;
      continue;
    }
    Triangle triangle;
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& id = ids[homes[k]];
      if (id == no_index) {
        id = static_cast<std::uint32_t>(welded.mesh.vertices.size());
        welded.mesh.vertices.push_back(gathering.position(homes[k]));
      }
      triangle[k] = id;
    }
    welded.mesh.triangles.push_back(triangle);
    welded.numbers.push_back(t);
    if (!mesh.patches.empty()) welded.mesh.patches.push_back(mesh.patches[t]);
  }
  welded.mesh.patch_names = mesh.patch_names;
}

}  // namespace

Result<Welded> weld(const Mesh& mesh, double tolerance, const Run& run) {
  const FloatingEnvironment environment;
  Progress progress(run);
  if (auto error = refused(mesh, tolerance)) return std::move(*error);
  progress.phase(0, 1, 4);
  Gathering gathering(mesh, tolerance);
  progress.step();
  if (!progress.cancelled()) gathering.keep();
  progress.step();
  Welded welded;
  if (!progress.cancelled()) gathering.move(welded.report);
  progress.step();
  if (progress.cancelled()) return Progress::error();
  rebuild(mesh, gathering, welded);
  if (welded.mesh.triangles.empty()) {
    return Error{Code::empty_mesh, 0, "no triangle is left: each has two corners at one place"};
  }
  return welded;
}

}  // namespace cdfr
