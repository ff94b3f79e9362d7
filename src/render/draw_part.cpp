#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/vector.h"
#include "render/draw.h"

namespace cdfr {
namespace {

// The two sides of an edge may round differently; by that much of a sample they overlap, so that no gap
// opens.
constexpr double overlap = 0x1p-16;

/// Columns of one row whose samples lie in a triangle.
struct Span {
  double first, last;
};

/// Half plane a x + b y + c >= 0.
struct HalfPlane {
  double a, b, c;
};

/// The edges of a triangle, inside where all are positive whichever way it turns.
std::array<HalfPlane, 3> half_planes(const std::array<Eigen::Vector3d, 3>& corners, double twice_area) {
  std::array<HalfPlane, 3> planes;
  const double side = twice_area > 0 ? 1 : -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& from = corners[k];
    const Eigen::Vector3d edge = side * (corners[(k + 1) % 3] - from);
    const double slack = overlap * (std::abs(edge.x()) + std::abs(edge.y()));
    planes[k] = {-edge.y(), edge.x(), edge.y() * from.x() - edge.x() * from.y() + slack};
  }
  return planes;
}

Span clip(Span span, const HalfPlane& plane, double y) {
  const double rest = plane.b * y + plane.c;
  if (plane.a > 0) {
    span.first = std::max(span.first, -rest / plane.a);
  } else if (plane.a < 0) {
    span.last = std::min(span.last, -rest / plane.a);
  } else if (rest < 0) {
    span.last = span.first - 1;
  }
  return span;
}

/// A triangle in the picture that is not seen edge-on.
struct Facet {
  std::array<Eigen::Vector3d, 3> corners;
  Eigen::Vector3d lo, hi;
  Eigen::Vector3d normal;  ///< of any length, z not zero
};

class TrianglePainter {
 public:
  TrianglePainter(const View& view, Band& band) : view_(view), band_(band) {}

  void draw(const std::array<Eigen::Vector3d, 3>& vertices) {
    Facet facet;
    for (std::size_t k = 0; k < 3; ++k) facet.corners[k] = view_.place(vertices[k]);
    const auto& [a, b, c] = facet.corners;
    facet.lo = a.cwiseMin(b).cwiseMin(c);
    facet.hi = a.cwiseMax(b).cwiseMax(c);
    const double first = std::max(std::ceil(facet.lo.y() - 0.5), double(band_.front.first_row()));
    const double last = std::min(std::floor(facet.hi.y() - 0.5), double(band_.front.end_row() - 1));
    if (!(first <= last)) return;
    facet.normal = (b - a).cross(c - a);
    if (facet.normal.z() == 0) return;
    draw_rows(facet, static_cast<int>(first), static_cast<int>(last));
  }

 private:
  void draw_rows(const Facet& facet, int first_row, int last_row) {
    const Eigen::Vector3d slope = -facet.normal / facet.normal.z();
    const Eigen::Vector3d unit = (facet.normal.z() > 0 ? -1.0 : 1.0) * facet.normal / facet.normal.norm();
    Sample sample{0, static_cast<float>(unit.x()), static_cast<float>(unit.y()),
                  static_cast<float>(unit.z())};
    const auto planes = half_planes(facet.corners, facet.normal.z());
    const Eigen::Vector3d& start = facet.corners[0];
    for (int row = first_row; row <= last_row; ++row) {
      const double y = row + 0.5;
      Span span{facet.lo.x(), facet.hi.x()};
      for (const HalfPlane& plane : planes) span = clip(span, plane, y);
      const double first = std::max(std::ceil(span.first - 0.5), 0.0);
      const double last = std::min(std::floor(span.last - 0.5), double(band_.front.width() - 1));
      if (!(first <= last)) continue;
      const double row_depth = start.z() + slope.y() * (y - start.y());
      for (int column = static_cast<int>(first); column <= static_cast<int>(last); ++column) {
        const double depth = row_depth + slope.x() * (column + 0.5 - start.x());
        sample.depth = static_cast<float>(std::clamp(depth, facet.lo.z(), facet.hi.z()));
        put(column, row, sample);
      }
    }
  }

  void put(int column, int row, const Sample& sample) {
    Sample& front = band_.front.at(column, row);
    if (sample.depth < front.depth) front = sample;
    Sample& back = band_.back.at(column, row);
    if (back.empty() || sample.depth > back.depth) back = sample;
  }

  const View& view_;
  Band& band_;
};

}  // namespace

void draw_part(MeshView part, const View& view, Band& band) {
  TrianglePainter painter(view, band);
  for (const Triangle& triangle : part.triangles) {
    painter.draw({to_eigen(part.vertices[triangle[0]]), to_eigen(part.vertices[triangle[1]]),
                  to_eigen(part.vertices[triangle[2]])});
  }
}

}  // namespace cdfr
