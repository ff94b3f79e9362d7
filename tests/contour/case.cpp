#include "contour/case.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace cdfr::test {
namespace {

class Keeper : public PointSink {
 public:
  explicit Keeper(std::vector<ContourPoint>& kept) : kept_(kept) {}
  Result<void> write(std::span<const ContourPoint> points) override {
    kept_.insert(kept_.end(), points.begin(), points.end());
    return {};
  }

 private:
  std::vector<ContourPoint>& kept_;
};

void expect_report_fits(const Contour& contour) {
  const ContourReport& report = contour.report;
  EXPECT_EQ(report.points, contour.points.size());
  EXPECT_LE(report.visited, report.leaves);
  EXPECT_LE(report.productive, report.visited);
  EXPECT_LE(report.productive, report.points);
  EXPECT_GT(report.subvoxel, 0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  double largest = 0;
  std::uint64_t undecided = 0;
  for (const ContourPoint& p : contour.points) {
    box.lo = {std::min(box.lo.x, p.position.x), std::min(box.lo.y, p.position.y),
              std::min(box.lo.z, p.position.z)};
    box.hi = {std::max(box.hi.x, p.position.x), std::max(box.hi.y, p.position.y),
              std::max(box.hi.z, p.position.z)};
    if (std::isfinite(p.error)) largest = std::max(largest, p.error);
    undecided += !std::isfinite(p.error);
  }
  EXPECT_EQ(report.box, box);
  EXPECT_EQ(report.max_error, largest);
  EXPECT_EQ(report.undecided, undecided);
}

/// 64 ulp at the largest coordinate in play.
double rounding_of(const Field& field, double distance) {
  const Box box = field.domain();
  const double largest = std::max({std::fabs(box.lo.x), std::fabs(box.lo.y), std::fabs(box.lo.z),
                                   std::fabs(box.hi.x), std::fabs(box.hi.y), std::fabs(box.hi.z)});
  return 64 * 0x1p-52 * (largest + std::fabs(distance));
}

double distance_to_triangle(const Mesh& mesh, std::uint32_t triangle, const Vec3& x) {
  Mesh one;
  for (const std::uint32_t v : mesh.triangles[triangle]) one.vertices.push_back(mesh.vertices[v]);
  one.triangles = {{0, 1, 2}};
  return closest_brute(one.view(), x, Sign::none).distance;
}

}  // namespace

Case::Case(Mesh made, const BuildOptions& options)
    : mesh(std::move(made)),
      field(Field::build(mesh.view(), options).value()),
      brute(BruteForce::over(mesh.view(), field.sign()).value()) {}

Contour contour_of(const Field& field, double distance, double tolerance) {
  Contour contour{distance, tolerance, {}, {}};
  Keeper keeper(contour.points);
  contour.report = contour_points(field, distance, {tolerance}, keeper).value();
  expect_report_fits(contour);
  return contour;
}

void expect_true_points(const Case& part, const Contour& contour, std::size_t stride) {
  const double t = contour.distance, rounding = rounding_of(part.field, t);
  for (std::size_t i = 0; i < contour.points.size(); i += stride) {
    const ContourPoint& p = contour.points[i];
    ASSERT_GE(p.error, 0);
    ASSERT_LT(p.triangle, part.mesh.triangles.size());
    const Vec3 n = p.normal;
    ASSERT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1, 1e-14);
    if (!std::isfinite(p.error)) continue;  // counted in the report
    ASSERT_LE(p.error, rounding);
    ASSERT_LE(std::fabs(part.brute.closest(p.position).distance - t), p.error) << "point " << i;
    // Back along the normal lies the foot, on the triangle that is named: true on the medial axis as well.
    const Vec3 foot{p.position.x - n.x * t, p.position.y - n.y * t, p.position.z - n.z * t};
    ASSERT_LE(std::fabs(part.brute.closest(foot).distance), 2 * rounding) << "point " << i;
    ASSERT_LE(distance_to_triangle(part.mesh, p.triangle, foot), 2 * rounding) << "point " << i;
  }
}

double half_angle_sine() { return std::sin(std::numbers::pi / 180); }

Mesh wedge_mesh() {
  const double l = wedge_length, h = l * std::tan(std::numbers::pi / 180);
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {l, 0, -h}, {l, 0, h}, {0, l, 0}, {l, l, -h}, {l, l, h}};
  mesh.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {0, 2, 5}, {0, 5, 3}, {1, 4, 5}, {1, 5, 2}};
  return mesh;
}

}  // namespace cdfr::test
