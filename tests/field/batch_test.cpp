#include <gtest/gtest.h>

#include <atomic>

#include "cdfr/field/field.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

TEST(Batch, EqualsSingleQueriesInInputOrder) {
  const Field field = Field::build(test::sphere_mesh(3).view()).value();
  test::Random random(4);
  std::vector<Vec3> points;
  for (int i = 0; i < 10000; ++i) points.push_back(random.in({{-2, -2, -2}, {2, 2, 2}}));
  std::vector<double> distances(points.size());
  std::vector<Closest> closest(points.size());
  const Points view{std::span<const Vec3>(points)};
  ASSERT_TRUE(field.distance(view, distances));
  ASSERT_TRUE(field.closest(view, closest));
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(test::same_bits(distances[i], field.distance(points[i])));
    EXPECT_TRUE(test::same_bits(closest[i], field.closest(points[i])));
  }
}

TEST(Batch, TakesStridedPointsAndNone) {
  const Field field = Field::build(test::box_mesh({{0, 0, 0}, {1, 1, 1}}).view()).value();
  const double rows[] = {2, 0.5, 0.5, 99, 0.5, 0.5, 0.5, 99};
  std::vector<double> out(2);
  ASSERT_TRUE(field.distance(Points(rows, 2, 4), out));
  EXPECT_EQ(out, (std::vector<double>{1, -0.5}));
  EXPECT_TRUE(field.distance(Points(), std::span<double>()));
}

bool stop_at_once(void* calls, double) noexcept {
  ++*static_cast<std::atomic<int>*>(calls);
  return false;
}

TEST(Batch, CancelsByName) {
  const Mesh mesh = test::sphere_mesh(5);
  std::atomic<int> calls = 0;
  cdfr::Run run;
  run.tick = stop_at_once;
  run.context = &calls;
  const Result<Field> built = Field::build(mesh.view(), {}, run);
  ASSERT_FALSE(built);
  EXPECT_EQ(built.error().code, Code::cancelled);
  const Field field = Field::build(mesh.view()).value();
  std::vector<Vec3> points(100000);
  std::vector<double> out(points.size());
  const Result<void> done = field.distance(Points{std::span<const Vec3>(points)}, out, run);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, Code::cancelled);
  EXPECT_GE(calls, 2);
}

bool watch(void* last, double done) noexcept {
  auto& previous = *static_cast<double*>(last);
  const bool forward = done >= previous && done <= 1;
  previous = forward ? done : 2;
  return forward;
}

TEST(Batch, ProgressNeverGoesBack) {
  double last = 0;
  cdfr::Run run;
  run.tick = watch;
  run.context = &last;
  const Mesh mesh = test::sphere_mesh(5);
  EXPECT_TRUE(Field::build(mesh.view(), {}, run));
  EXPECT_LE(last, 1);
  EXPECT_GT(last, 0.5);
}

}  // namespace
}  // namespace cdfr
