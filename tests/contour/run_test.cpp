// Threads, instruction sets, cancel and the sink's own errors.
#include <gtest/gtest.h>

#include "cdfr/parts/part.h"
#include "contour/case.h"
#include "core/collected_points.h"
#include "support/instruction_sets.h"
#include "support/meshes.h"
#include "support/same.h"
#include "support/ticks.h"

namespace cdfr {
namespace {

Field sphere_field() { return Field::build(test::sphere_mesh(4).view()).value(); }

bool same(const ContourPoint& a, const ContourPoint& b) {
  return test::same_bits(a.position, b.position) && test::same_bits(a.normal, b.normal) &&
         a.triangle == b.triangle && test::same_bits(a.error, b.error);
}

TEST(ContourRun, SamePointsInTheSameOrderForAnyThreads) {
  const Field field = sphere_field();
  for (const double distance : {-0.5, 0.0, 0.6}) {
    cdfr::Run run;
    run.threads = 1;
    const auto expected = contour_points(field, distance, {0.06}, run).value();
    ASSERT_GT(expected.size(), 1000U);
    for (const unsigned threads : {2U, 7U, 0U}) {
      run.threads = threads;
      const auto points = contour_points(field, distance, {0.06}, run).value();
      ASSERT_EQ(points.size(), expected.size());
      for (std::size_t i = 0; i < points.size(); ++i) ASSERT_TRUE(same(points[i], expected[i])) << i;
    }
  }
}

TEST(ContourRun, SamePointsFromFieldsBuiltByAnyThreads) {
  const Mesh mesh = test::sphere_mesh(4);
  cdfr::Run run;
  run.threads = 1;
  const auto expected = contour_points(Field::build(mesh.view(), {}, run).value(), -0.5, {0.1}).value();
  run.threads = 7;
  const auto points = contour_points(Field::build(mesh.view(), {}, run).value(), -0.5, {0.1}).value();
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) ASSERT_TRUE(same(points[i], expected[i])) << i;
}

TEST(ContourRun, SamePointsAndWorkOnEveryInstructionSet) {
  for (const char* part : {"six-star", "one-tooth"}) {
    const Field field = Field::build(make_part(part).value().view()).value();
    for (const double distance : {-0.11, 0.07}) {
      CollectedPoints expected;
      const ContourReport first = contour_points(field, distance, {0.04}, expected).value();
      ASSERT_GT(first.points, 1000U);
      test::on_every_instruction_set([&] {
        CollectedPoints collected;
        const ContourReport report = contour_points(field, distance, {0.04}, collected).value();
        ASSERT_EQ(report.points, first.points);
        ASSERT_EQ(report.evaluations, first.evaluations);
        for (std::size_t i = 0; i < collected.points.size(); ++i)
          ASSERT_TRUE(same(collected.points[i], expected.points[i])) << part << ' ' << i;
      });
    }
  }
}

TEST(ContourRun, TickCancelsEarlyAndLate) {
  const Field field = sphere_field();
  for (const int after : {0, 1, 3}) {
    test::Ticks ticks;
    ticks.left = after;
    cdfr::Run run;
    run.threads = 2;
    run.tick = test::count_down;
    run.context = &ticks;
    const auto result = contour_points(field, -0.3, {0.02}, run);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Code::cancelled);
    EXPECT_FALSE(ticks.twice);
  }
}

TEST(ContourRun, TickIsToldTheShareDone) {
  const Field field = sphere_field();
  test::Ticks ticks;
  ticks.left = 1 << 30;
  cdfr::Run run;
  run.threads = 1;
  run.tick = test::count_down;
  run.context = &ticks;
  ASSERT_TRUE(contour_points(field, -0.3, {0.1}, run));
  EXPECT_LT(ticks.left, 1 << 30);
  EXPECT_FALSE(ticks.twice);
  EXPECT_FALSE(ticks.disorder);
  EXPECT_GT(ticks.last, 0.9);
}

class Refusing : public PointSink {
 public:
  explicit Refusing(int blocks) : blocks_(blocks) {}
  Result<void> write(std::span<const ContourPoint> points) override {
    EXPECT_FALSE(points.empty());
    EXPECT_FALSE(refused_) << "written to after an error";
    if (blocks_-- > 0) return {};
    refused_ = true;
    return Error{Code::file_write, 42, "the disk is full"};
  }

 private:
  int blocks_;
  bool refused_ = false;
};

TEST(ContourRun, ErrorOfTheSinkEndsItAndIsPassedOn) {
  const Field field = sphere_field();
  for (const int blocks : {0, 1}) {
    Refusing sink(blocks);
    const auto result = contour_points(field, -0.3, {0.05}, sink);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Code::file_write);
    EXPECT_EQ(result.error().where, 42U);
    EXPECT_EQ(result.error().text, "the disk is full");
  }
}

}  // namespace
}  // namespace cdfr
