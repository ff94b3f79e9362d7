// Options that are refused, queries at the borders, threads, cancel and sinks.
#include "cdfr/reference/uniform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "cdfr/reference/uniform_contour.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

const Box unit_box{{0, 0, 0}, {1, 1, 1}};

Code refused(const Mesh& mesh, const UniformOptions& options) {
  const auto field = UniformField::build(mesh.view(), options);
  EXPECT_FALSE(field);
  if (field) return Code{};
  EXPECT_FALSE(field.error().text.empty());
  return field.error().code;
}

TEST(UniformOptions, AreRefusedByName) {
  const Mesh cube = test::box_mesh(unit_box);
  for (const int resolution :
       {0, -1, 65537, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
    UniformOptions options;
    options.resolution = resolution;
    EXPECT_EQ(refused(cube, options), Code::bad_option) << resolution;
  }
  for (const int border : {0, -1, 65, std::numeric_limits<int>::max()}) {
    UniformOptions options;
    options.border = border;
    EXPECT_EQ(refused(cube, options), Code::bad_option) << border;
  }
  UniformOptions large;
  large.resolution = 512;
  EXPECT_EQ(refused(cube, large), Code::bad_option) << "514^3 voxels";
}

TEST(UniformOptions, MeshesThatHaveNoFieldAreRefusedByName) {
  EXPECT_EQ(refused({}, {}), Code::empty_mesh);
  Mesh bad = test::box_mesh(unit_box);
  bad.triangles[3][1] = 8;
  EXPECT_EQ(refused(bad, {}), Code::bad_index);
  Mesh wild = test::box_mesh(unit_box);
  wild.vertices[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused(wild, {}), Code::not_finite);
  Mesh point;
  point.vertices.assign(3, {1, 2, 3});
  point.triangles = {{0, 1, 2}};
  EXPECT_EQ(refused(point, {}), Code::bad_option);
  EXPECT_EQ(refused(test::sphere_mesh(0, 1e-3, {1e9, 0, 0}), {}), Code::out_of_range);
}

TEST(UniformField, TakesFlatAndDegenerateMeshes) {
  Mesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 1, 1}};
  UniformOptions options;
  options.resolution = 8;
  options.keep_outside = true;
  const UniformField field = UniformField::build(flat.view(), options).value();
  EXPECT_EQ(field.counts(), (std::array<int, 3>{10, 6, 3}));
  EXPECT_EQ(std::fabs(field.distance({0.25, 0.25, 0.125})), 0.125);
  EXPECT_EQ(std::fabs(field.distance({1.5, 0, 0.125})), 0.125);
}

TEST(UniformField, AnswersWithNaNWhereItHasNoList) {
  const UniformField field = UniformField::build(test::sphere_mesh(2).view()).value();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Vec3& x : {Vec3{nan, 0, 0}, Vec3{0, infinity, 0}, Vec3{0, 0, -infinity}, Vec3{1e300, 0, 0},
                        Vec3{2, 0, 0}, Vec3{0, -1.2, 0}, Vec3{0.98, 0.98, 0.98}}) {
    EXPECT_TRUE(std::isnan(field.distance(x)));
    EXPECT_EQ(field.closest(x).triangle, no_index);
  }
  EXPECT_LT(field.distance({0, 0, 0}), 0);
}

TEST(UniformField, VoxelsTileTheGridAndAreFound) {
  const UniformField field = UniformField::build(test::sphere_mesh(1, 0.3, {1e5, 0.1, -7}).view()).value();
  for (std::size_t cell = 0; cell < field.cell_count(); cell += 7) {
    const Box box = field.box(cell);
    EXPECT_EQ(field.locate(box.lo), cell);
    EXPECT_NE(field.locate(box.hi), cell);
    const double last = std::nextafter(box.hi.x, box.lo.x);
    EXPECT_EQ(field.locate({last, box.lo.y, box.lo.z}), cell);
  }
}

TEST(UniformField, IsTheSameForAnyThreads) {
  const Mesh sphere = test::sphere_mesh(3);
  cdfr::Run run;
  run.threads = 1;
  UniformOptions options;
  options.resolution = 12;
  const UniformField expected = UniformField::build(sphere.view(), options, run).value();
  const auto expected_points = contour_points(expected, 0.4, {0.06}, run).value();
  EXPECT_GT(expected_points.size(), 1000U);
  for (const unsigned threads : {2U, 5U, 0U}) {
    run.threads = threads;
    const UniformField field = UniformField::build(sphere.view(), options, run).value();
    EXPECT_EQ(field.stats().rounds, expected.stats().rounds);
    EXPECT_EQ(field.stats().measured, expected.stats().measured);
    for (std::size_t cell = 0; cell < field.cell_count(); ++cell) {
      ASSERT_TRUE(std::ranges::equal(field.list(cell), expected.list(cell)));
    }
    const auto points = contour_points(field, 0.4, {0.06}, run).value();
    ASSERT_EQ(points.size(), expected_points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_TRUE(test::same_bits(points[i].position, expected_points[i].position));
      ASSERT_TRUE(test::same_bits(points[i].normal, expected_points[i].normal));
    }
  }
}

bool count_down(void* context, double done) noexcept {
  EXPECT_GE(done, 0);
  EXPECT_LE(done, 1 + 1e-9);
  return (*static_cast<std::atomic<int>*>(context))-- > 0;
}

TEST(UniformField, CancelsEarlyAndLate) {
  const Mesh sphere = test::sphere_mesh(3);
  UniformOptions options;
  options.resolution = 12;
  const UniformField field = UniformField::build(sphere.view(), options).value();
  for (const int after : {0, 3, 600}) {
    std::atomic<int> left = after;
    cdfr::Run run;
    run.tick = count_down;
    run.context = &left;
    const auto result = UniformField::build(sphere.view(), options, run);
    ASSERT_FALSE(result) << after;
    EXPECT_EQ(result.error().code, Code::cancelled);
    left = std::min(after, 20);
    const auto points = contour_points(field, 0.4, {0.05}, run);
    ASSERT_FALSE(points) << after;
    EXPECT_EQ(points.error().code, Code::cancelled);
  }
}

TEST(UniformContour, OptionsAreRefusedByName) {
  const UniformField field = UniformField::build(test::box_mesh(unit_box).view()).value();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double depth : {0.0, -0.1, nan, infinity, -infinity}) {
    const auto result = contour_points(field, depth, {0.1});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Code::bad_option);
  }
  for (const double tolerance : {-0.1, nan, infinity, 1e-300, 1.0 / 32 / 65 * 0.86}) {
    const auto result = contour_points(field, 0.2, {tolerance});
    ASSERT_FALSE(result) << tolerance;
    EXPECT_EQ(result.error().code, Code::bad_option);
  }
  EXPECT_EQ(contour_points(field, 3, {0.1}).value().size(), 0U) << "an empty contour is an answer";
}

class Refusing : public PointSink {
 public:
  Result<void> write(std::span<const ContourPoint>) override { return Error{Code::file_write, 7, "full"}; }
};

TEST(UniformContour, HandsOnTheSinksError) {
  const UniformField field = UniformField::build(test::box_mesh(unit_box).view()).value();
  Refusing sink;
  const auto result = contour_points(field, 0.2, {0.02}, sink);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Code::file_write);
  EXPECT_EQ(result.error().where, 7U);
}

TEST(UniformContour, ReportFitsThePoints) {
  const UniformField field = UniformField::build(test::box_mesh(unit_box).view()).value();
  struct Counting : PointSink {
    Result<void> write(std::span<const ContourPoint> points) override {
      EXPECT_FALSE(points.empty());
      count += points.size();
      for (const ContourPoint& p : points) {
        const Vec3 n = p.normal;
        EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1, 1e-14);
      }
      return {};
    }
    std::size_t count = 0;
  } sink;
  const UniformContourReport report = contour_points(field, 0.481, {}, sink).value();
  EXPECT_EQ(report.points, sink.count);
  EXPECT_GT(report.productive, 0U);
  EXPECT_LE(report.productive, report.visited);
  EXPECT_LE(report.visited, report.regions);
  EXPECT_GT(report.evaluations, report.points);
  EXPECT_LT(std::sqrt(3) / 2 * report.subvoxel, 1.0 / 500);
  EXPECT_GT(std::sqrt(3) / 2 * report.subvoxel, 0.9 / 500);
}

}  // namespace
}  // namespace cdfr
