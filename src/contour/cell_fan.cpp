#include "contour/cell_fan.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "contour/qef.h"
#include "core/parallel.h"
#include "core/vector.h"
#include "field/query.h"

namespace cdfr {
namespace {

constexpr std::size_t faces_a_task = 256;
constexpr std::size_t leaves_a_task = 128;
/// Of the tolerance: a corner that stands out by less is not worth a vertex.
constexpr double visible_share = 1.0 / 64;
/// A corner of the contour has its distance but for rounding and curvature; on a round part the point where
/// tangents meet is off by half of what it stands out by.
constexpr double sharp_share = 1.0 / 4;
/// Of the tolerance: a distance that is right but for rounding and curvature.
constexpr double good_share = 1.0 / 256;
/// Spread of normals, as a share of the number of planes, from which a direction counts: 0.03 and 0.2 radians
/// about.
constexpr double small_spread = 1e-3, clear_spread = 4e-2;

Eigen::Vector3d clamped(const Eigen::Vector3d& x, const Eigen::Vector3d& lo, double size) noexcept {
  const double hair = size * hair_share;
  return x.cwiseMax(lo.array().matrix() + Eigen::Vector3d::Constant(hair))
      .cwiseMin(lo + Eigen::Vector3d::Constant(size - hair));
}

bool is_inside(const Eigen::Vector3d& x, const Eigen::Vector3d& lo, double size) noexcept {
  return clamped(x, lo, size) == x;
}

}  // namespace

bool CellFans::place(Progress& progress) { return place_bends(progress) && place_apexes(progress); }

void CellFans::add(const std::vector<Tally>& tallies) {
  for (const Tally& tally : tallies) {
    loose_.insert(loose_.end(), tally.loose.begin(), tally.loose.end());
    largest_error_ = std::max(largest_error_, tally.largest_error);
    evaluations_ += tally.evaluations;
  }
}

/// Where the tangents at a piece's ends, in the plane of the face, meet.
CellFans::Bend CellFans::bend_of(const CurvePiece& piece, const MinimalFace& face, Tally& tally) const {
  const SurfaceLeaf& owner = leaves_.leaves()[face.of_above ? face.above : face.below];
  const SurfaceCell& cell = leaves_.octree().cell(owner.cell);
  const SurfaceLattice& lattice = leaves_.octree().lattice();
  const double size = lattice.size(cell.level);
  const Eigen::Vector3d lo = to_eigen(lattice.corner(cell.lo));
  const Eigen::Index b = (face.axis + 1) % 3, c = (face.axis + 2) % 3;
  const Crossing &from = crossings_[piece.from], &to = crossings_[piece.to];
  const Eigen::Vector3d p = to_eigen(from.position), q = to_eigen(to.position);
  const Eigen::Vector3d m = to_eigen(from.gradient), n = to_eigen(to.gradient);
  const double determinant = m[b] * n[c] - m[c] * n[b];
  if (!(std::fabs(determinant) > 1e-6)) return {};
  // m.(x - p) = -excess there, n.(x - p) = n.(q - p) - excess here.
  const double at_p = -from.excess, at_q = n[b] * (q[b] - p[b]) + n[c] * (q[c] - p[c]) - to.excess;
  Eigen::Vector3d x = p;
  x[b] = p[b] + (at_p * n[c] - m[c] * at_q) / determinant;
  x[c] = p[c] + (m[b] * at_q - at_p * n[b]) / determinant;
  const double hair = size * hair_share;
  if (!(x[b] > lo[b] + hair && x[b] < lo[b] + size - hair && x[c] > lo[c] + hair &&
        x[c] < lo[c] + size - hair))
    return {};
  const double chord = (q - p).norm();
  const double out = std::fabs((x[b] - p[b]) * (q[c] - p[c]) - (x[c] - p[c]) * (q[b] - p[b]));
  if (!(out > visible_share * sought_.tolerance * chord)) return {};
  ++tally.evaluations;
  const double excess = std::fabs(signed_distance(sought_.field, from_eigen(x)) - sought_.distance);
  if (!(excess * chord <= sharp_share * out) || excess > sought_.tolerance / 2) return {};
  tally.largest_error = std::max(tally.largest_error, excess);
  return {from_eigen(x), true};
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
        if (piece.face == i) bends_[i] = bend_of(piece, face, tallies[first / faces_a_task]);
      }
    }
  });
  add(tallies);
  return !progress.cancelled();
}

Vec3 CellFans::apex_of(std::uint32_t number, CurveLoop loop, Tally& tally) const {
  const SurfaceCell& cell = leaves_.octree().cell(leaves_.leaves()[number].cell);
  const SurfaceLattice& lattice = leaves_.octree().lattice();
  const double size = lattice.size(cell.level);
  const Eigen::Vector3d lo = to_eigen(lattice.corner(cell.lo));
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  double points = 0;
  for (const CurvePiece& piece : loop) {
    mean += to_eigen(crossings_[piece.from].position) - lo;
    normal += to_eigen(crossings_[piece.from].gradient);
    points += 1;
    if (!bends_[piece.face].is_there) continue;
    mean += to_eigen(bends_[piece.face].position) - lo;
    points += 1;
  }
  mean = lo + mean / points;
  if (many_loops(number)) return from_eigen(clamped(mean, lo, size));
  PlaneMeeting meeting;
  double height = 0;
  for (const CurvePiece& piece : loop) {
    const Crossing& crossing = crossings_[piece.from];
    const Eigen::Vector3d gradient = to_eigen(crossing.gradient);
    const double offset = gradient.dot(to_eigen(crossing.position) - mean) - crossing.excess;
    meeting.add(gradient, offset);
    height += offset;
  }
  const double length = normal.norm();
  const Eigen::Vector3d smooth = length > 0.1 * static_cast<double>(loop.size())
                                     ? Eigen::Vector3d(mean + normal * (height / (length * length)))
                                     : mean;
  const Eigen::Vector3d round = clamped(smooth, lo, size);
  const auto excess_at = [&](const Eigen::Vector3d& x) {
    ++tally.evaluations;
    return std::fabs(signed_distance(sought_.field, from_eigen(x)) - sought_.distance);
  };
  double at_round = -1;
  for (const double spread : {small_spread, clear_spread}) {
    int rank = 0;
    const Eigen::Vector3d sharp = mean + meeting.point(spread, rank);
    if (rank < 2 || (sharp - round).norm() <= visible_share * sought_.tolerance) break;
    if (!is_inside(sharp, lo, size)) continue;
    if (at_round < 0) at_round = excess_at(round);
    const double at_sharp = excess_at(sharp);
    if (at_sharp > std::max(at_round, good_share * sought_.tolerance)) continue;
    tally.largest_error = std::max(tally.largest_error, at_sharp);
    return from_eigen(sharp);
  }
  return from_eigen(round);
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
        check(leaf, tally);
    }
  });
  add(tallies);
  return !progress.cancelled();
}

void CellFans::check(std::uint32_t leaf, Tally& tally) const {
  const Eigen::Vector3d apex = to_eigen(apexes_[first_apex_[leaf]]);
  double largest = 0;
  const auto measure_centroid = [&](const Vec3& p, const Vec3& q) {
    const Eigen::Vector3d centroid = (apex + to_eigen(p) + to_eigen(q)) / 3;
    ++tally.evaluations;
    largest =
        std::max(largest, std::fabs(signed_distance(sought_.field, from_eigen(centroid)) - sought_.distance));
  };
  for (const CurvePiece& piece : conforming_.curves().pieces(leaf)) {
    const Vec3 from = crossings_[piece.from].position, to = crossings_[piece.to].position;
    const Bend& bend = bends_[piece.face];
    if (bend.is_there) {
      measure_centroid(from, bend.position);
      measure_centroid(bend.position, to);
    } else {
      measure_centroid(from, to);
    }
  }
  tally.largest_error = std::max(tally.largest_error, largest);
  if (largest > sought_.tolerance) tally.loose.push_back(leaf);
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
        const Bend& bend = bends_[piece.face];
        if (bend.is_there) {
          const std::uint32_t middle = vertex(bend_vertex[piece.face], bend.position);
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
