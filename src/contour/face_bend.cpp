#include "contour/face_bend.h"

#include <algorithm>
#include <cmath>

#include "core/vector.h"
#include "field/query.h"

namespace cdfr {
namespace {

/// Of the tolerance: what a bend between nearly equal tangents stands out by, to be worth a vertex.
constexpr double visible_share = 1.0 / 64;
/// Cosine below which tangents are that different that any bend is.
constexpr double clear_cosine = 0.9;
constexpr double sharp_share = 1.0 / 4;

}  // namespace

std::optional<Vec3> face_bend(const Sought& sought, const PlainCube& cube, int axis, const Crossing& from,
                              const Crossing& to, SurfaceTally& tally) {
  const Eigen::Index b = (axis + 1) % 3, c = (axis + 2) % 3;
  const Eigen::Vector3d p = to_eigen(from.position), q = to_eigen(to.position);
  const Eigen::Vector3d m = to_eigen(from.gradient), n = to_eigen(to.gradient);
  const double determinant = m[b] * n[c] - m[c] * n[b];
  if (!(std::fabs(determinant) > 1e-6)) return std::nullopt;
  // m.(x - p) = -excess there and n.(x - p) = n.(q - p) - excess here, in the plane.
  const double at_p = -from.excess, at_q = n[b] * (q[b] - p[b]) + n[c] * (q[c] - p[c]) - to.excess;
  Eigen::Vector3d x = p;
  x[b] = p[b] + (at_p * n[c] - m[c] * at_q) / determinant;
  x[c] = p[c] + (m[b] * at_q - at_p * n[b]) / determinant;
  const Eigen::Vector3d held = cube.held(x);
  if (held[b] != x[b] || held[c] != x[c]) return std::nullopt;
  const double chord = (q - p).norm();
  const double out = std::fabs((x[b] - p[b]) * (q[c] - p[c]) - (x[c] - p[c]) * (q[b] - p[b])) / chord;
  if (out <= 64 * sought.rounding) return std::nullopt;
  if (out <= visible_share * sought.tolerance && m.dot(n) > clear_cosine) return std::nullopt;
  ++tally.evaluations;
  const double excess = std::fabs(signed_distance(sought.field, from_eigen(x)) - sought.distance);
  if (excess > sharp_share * out || excess > sought.tolerance / 2) return std::nullopt;
  tally.largest_error = std::max(tally.largest_error, excess);
  return from_eigen(x);
}

}  // namespace cdfr
