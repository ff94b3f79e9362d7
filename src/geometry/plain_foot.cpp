#include "geometry/plain_foot.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "core/vector.h"

namespace cdfr {
namespace {

/// Offset of p from the closest point of a segment from `start` along `edge`; `from` is p - start.
Eigen::Vector3d from_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& edge) noexcept {
  const double along = from.dot(edge), square = edge.squaredNorm();
  if (!(along > 0)) return from;
  if (along >= square) return from - edge;
  return from - edge * (along / square);
}

}  // namespace

PlainFoot plain_foot(const Eigen::Vector3d& p, const TriangleShape& triangle) noexcept {
  const auto& v = triangle.vertices;
  const Eigen::Vector3d a = to_eigen(v[0]), b = to_eigen(v[1]), c = to_eigen(v[2]);
  const Eigen::Vector3d pa = p - a, pb = p - b, pc = p - c;
  const Eigen::Vector3d ab = b - a, bc = c - b, ca = a - c;
  const Eigen::Vector3d normal(triangle.normal[0].hi, triangle.normal[1].hi, triangle.normal[2].hi);
  const double sure = 0x1p-40 * (pa.squaredNorm() + pb.squaredNorm() + pc.squaredNorm());
  const bool inside =
      normal.dot(ab.cross(pa)) > sure && normal.dot(bc.cross(pb)) > sure && normal.dot(ca.cross(pc)) > sure;
  if (inside && !normal.isZero(0)) {
    const double height = normal.dot(pa);
    return {std::fabs(height), height < 0 ? Eigen::Vector3d(-normal) : normal};
  }
  Eigen::Vector3d best = from_segment(pa, ab);
  double least = best.squaredNorm();
  for (const Eigen::Vector3d& offset : {from_segment(pb, bc), from_segment(pc, ca)}) {
    const double square = offset.squaredNorm();
    if (square < least) {
      least = square;
      best = offset;
    }
  }
  const double distance = std::sqrt(least);
  return {distance, distance > 0 ? Eigen::Vector3d(best / distance) : Eigen::Vector3d::Zero()};
}

}  // namespace cdfr
