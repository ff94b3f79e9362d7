#include "contour/cell_fan.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "contour/face_bend.h"
#include "core/parallel.h"
#include "core/vector.h"
#include "field/batch.h"

namespace cdfr {
namespace {

constexpr std::size_t faces_a_task = 256;
constexpr std::size_t leaves_a_task = 128;
/// Of the tolerance: what a check at few points lets pass.
constexpr double check_share = 3.0 / 4;

}  // namespace

bool CellFans::place(Progress& progress) { return place_bends(progress) && place_apexes(progress); }

void CellFans::add(const std::vector<Tally>& tallies) {
  for (const Tally& tally : tallies) {
    loose_.insert(loose_.end(), tally.loose.begin(), tally.loose.end());
    largest_error_ = std::max(largest_error_, tally.measured.largest_error);
    evaluations_ += tally.measured.evaluations;
  }
}

PlainCube CellFans::cube_of(std::uint32_t leaf) const {
  const SurfaceCell& cell = leaves_.octree().cell(leaves_.leaves()[leaf].cell);
  const SurfaceLattice& lattice = leaves_.octree().lattice();
  return {to_eigen(lattice.corner(cell.lo)), lattice.size(cell.level)};
}

bool CellFans::place_bends(Progress& progress) {
  const std::span<const MinimalFace> faces = conforming_.curves().faces();
  bends_.assign(faces.size(), {});
  std::vector<Tally> tallies((faces.size() + faces_a_task - 1) / faces_a_task);
  for_chunks(faces.size(), faces_a_task, [&](std::size_t first, std::size_t end) {
    if (!progress.poll()) return;
    for (std::size_t i = first; i < end; ++i) {
      const MinimalFace& face = faces[i];
      if (face.pieces != 1 || many_loops(face.below) || many_loops(face.above)) continue;
      // The cell below has the face's only piece.
      for (const CurvePiece& piece : conforming_.curves().pieces(face.below)) {
        if (piece.face != i) continue;
        bends_[i] =
            face_bend(sought_, cube_of(face.of_above ? face.above : face.below), face.axis,
                      crossings_[piece.from], crossings_[piece.to], tallies[first / faces_a_task].measured);
      }
    }
  });
  add(tallies);
  return !progress.cancelled();
}

/// The mean of a loop takes its lines by their length: finer neighbours do not draw it to them.
Vec3 CellFans::apex_of(std::uint32_t leaf, CurveLoop loop, Tally& tally) const {
  const PlainCube cube = cube_of(leaf);
  std::vector<WeightedCrossing>& crossings = tally.crossings;
  crossings.clear();
  for (const CurvePiece& piece : loop) crossings.push_back({&crossings_[piece.from], 0});
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    WeightedCrossing &from = crossings[i], &to = crossings[i + 1 == loop.size() ? 0 : i + 1];
    const Eigen::Vector3d p = to_eigen(from.crossing->position), q = to_eigen(to.crossing->position);
    const std::optional<Vec3>& bend = bends_[loop[i].face];
    const Eigen::Vector3d middle = bend ? to_eigen(*bend) : Eigen::Vector3d((p + q) / 2);
    const double before = (middle - p).norm(), after = (q - middle).norm();
    sum += before * ((p + middle) / 2 - cube.lo) + after * ((middle + q) / 2 - cube.lo);
    total += before + after;
    from.weight += before;
    to.weight += after;
  }
  const Eigen::Vector3d mean = cube.held(cube.lo + sum / total);
  return from_eigen(many_loops(leaf) ? mean : cell_apex(sought_, cube, mean, crossings, tally.measured));
}

bool CellFans::place_apexes(Progress& progress) {
  const std::size_t count = leaves_.leaves().size();
  first_apex_.assign(count + 1, 0);
  std::uint32_t total = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    first_apex_[i] = total;
    const std::size_t starts = conforming_.loops(i).size();
    if (starts > 0) total += static_cast<std::uint32_t>(starts - 1);
  }
  first_apex_[count] = total;
  apexes_.resize(total);
  std::vector<Tally> tallies((count + leaves_a_task - 1) / leaves_a_task);
  for_chunks(count, leaves_a_task, [&](std::size_t first, std::size_t end) {
    if (!progress.poll()) return;
    Tally& tally = tallies[first / leaves_a_task];
    for (std::size_t i = first; i < end; ++i) {
      const auto leaf = static_cast<std::uint32_t>(i);
      const std::span<const std::uint32_t> starts = conforming_.loops(leaf);
      for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
        const CurveLoop loop =
            conforming_.curves().pieces(leaf).subspan(starts[k], starts[k + 1] - starts[k]);
        apexes_[first_apex_[i] + k] = apex_of(leaf, loop, tally);
      }
      if (!starts.empty() && leaves_.level(leaves_.leaves()[i]) < leaves_.octree().lattice().finest())
        add_checks(leaf, tally);
    }
    check(tally, progress);
  });
  add(tallies);
  return !progress.cancelled();
}

/// In a cell of one plane the apex tells: the other vertices are on the contour, and what is between them is
/// within the slack of the plane. Where planes meet a missed bend shows at centroids and at the middles of
/// pieces that join different planes.
void CellFans::add_checks(std::uint32_t leaf, Tally& tally) const {
  const auto add = [&](const Eigen::Vector3d& x) {
    tally.checked.push_back(from_eigen(x));
    tally.checked_leaf.push_back(leaf);
  };
  const Eigen::Vector3d apex = to_eigen(apexes_[first_apex_[leaf]]);
  if (leaves_.octree().cell(leaves_.leaves()[leaf].cell).planes == 1) {
    add(apex);
    return;
  }
  for (const CurvePiece& piece : conforming_.curves().pieces(leaf)) {
    const Crossing &from = crossings_[piece.from], &to = crossings_[piece.to];
    const Eigen::Vector3d p = to_eigen(from.position), q = to_eigen(to.position);
    const std::optional<Vec3>& bend = bends_[piece.face];
    if (!bend) {
      add((apex + p + q) / 3);
      if (to_eigen(from.gradient).dot(to_eigen(to.gradient)) < 0.99) add((p + q) / 2);
    } else {
      add((apex + p + to_eigen(*bend)) / 3);
      add((apex + to_eigen(*bend) + q) / 3);
      add((apex + to_eigen(*bend)) / 2);
    }
  }
}

void CellFans::check(Tally& tally, Progress& progress) const {
  std::vector<double> values(tally.checked.size());
  if (!answer(sought_.field, std::span<const Vec3>(tally.checked), 0, std::span(values), progress)) return;
  tally.measured.evaluations += values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double excess = std::fabs(values[i] - sought_.distance);
    tally.measured.largest_error = std::max(tally.measured.largest_error, excess);
    if (!(excess > check_share * sought_.tolerance)) continue;
    if (tally.loose.empty() || tally.loose.back() != tally.checked_leaf[i])
      tally.loose.push_back(tally.checked_leaf[i]);
  }
}

Mesh CellFans::mesh() const {
  Mesh mesh;
  std::vector<std::uint32_t> crossing_vertex(crossings_.size(), no_index),
      bend_vertex(bends_.size(), no_index);
  const auto vertex = [&](std::uint32_t& known, const Vec3& position) {
    if (known == no_index) {
      known = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(position);
    }
    return known;
  };
  for (std::uint32_t leaf = 0; leaf + 1 < first_apex_.size(); ++leaf) {
    const std::span<const std::uint32_t> starts = conforming_.loops(leaf);
    for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
      const auto apex = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(apexes_[first_apex_[leaf] + k]);
      for (const CurvePiece& piece :
           conforming_.curves().pieces(leaf).subspan(starts[k], starts[k + 1] - starts[k])) {
        const std::uint32_t from = vertex(crossing_vertex[piece.from], crossings_[piece.from].position);
        const std::uint32_t to = vertex(crossing_vertex[piece.to], crossings_[piece.to].position);
        const std::optional<Vec3>& bend = bends_[piece.face];
        if (bend) {
          const std::uint32_t middle = vertex(bend_vertex[piece.face], *bend);
          mesh.triangles.push_back({apex, from, middle});
          mesh.triangles.push_back({apex, middle, to});
        } else {
          mesh.triangles.push_back({apex, from, to});
        }
      }
    }
  }
  return mesh;
}

}  // namespace cdfr
