// A const query that keeps its last leaf or triangle for the next one is a data race, and its answers depend
// on what was asked before. To be run under a thread sanitizer as well.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "cdfr/field/field.h"
#include "faults/star.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

struct Asked {
  std::vector<Vec3> points;
  std::vector<Closest> answers;
};

/// Every second point is near the one before, where a cache would keep what it has.
Asked asked_in_order(const Field& field, std::size_t count) {
  Asked asked;
  test::Random random(1);
  const Box around = test::scaled(field.domain(), 1.5);
  const double near = test::longest(around) / 100;
  Vec3 p;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 by = random.in({{-near, -near, -near}, {near, near, near}});
    p = i % 2 == 0 ? random.in(around) : Vec3{p.x + by.x, p.y + by.y, p.z + by.z};
    asked.points.push_back(p);
    asked.answers.push_back(field.closest(p));
  }
  return asked;
}

/// Every point once, in an order of its own for each odd step. Precondition: the count is a power of two.
std::size_t differing(const Field& field, const Asked& asked, std::size_t step) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < asked.points.size(); ++i) {
    const std::size_t at = i * step % asked.points.size();
    wrong += !test::same_bits(field.closest(asked.points[at]), asked.answers[at]);
    const std::size_t other = (at + step) % asked.points.size();
    wrong += !test::same_bits(field.distance(asked.points[other]), asked.answers[other].distance);
  }
  return wrong;
}

TEST(HiddenCache, AnswersDoNotDependOnWhatWasAskedBefore) {
  const Field field = Field::build(test::spiky_star(3, 1).view()).value();
  const Asked asked = asked_in_order(field, 4096);
  for (const std::size_t step : {1U, 3U, 1001U, 4095U}) EXPECT_EQ(differing(field, asked, step), 0U);
}

TEST(HiddenCache, ManyThreadsAtOnceGetTheSameBits) {
  Mesh open = test::spiky_star(3, 2);
  open.triangles.resize(open.triangles.size() - 20);
  for (const Mesh& mesh : {test::spiky_star(3, 2), open}) {
    const Field field = Field::build(mesh.view()).value();
    const Asked asked = asked_in_order(field, 2048);
    std::atomic<std::size_t> wrong = 0;
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 8; ++i) {
      threads.emplace_back(
          [&, copy = field, i] { wrong += differing(i % 2 == 0 ? field : copy, asked, 2 * i + 5); });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0U);
  }
}

Run with_threads(unsigned threads) {
  Run run;
  run.threads = threads;
  return run;
}

TEST(HiddenCache, ABatchIsItsPointsOneByOne) {
  const Field field = Field::build(test::spiky_star(3, 3).view()).value();
  const Asked asked = asked_in_order(field, 4096);
  for (const unsigned threads : {1U, 2U, 7U}) {
    const auto run = with_threads(threads);
    std::vector<Closest> answers(asked.points.size());
    std::vector<double> distances(asked.points.size());
    ASSERT_TRUE(field.closest(Points(asked.points), answers, run));
    ASSERT_TRUE(field.distance(Points(asked.points), distances, run));
    for (std::size_t i = 0; i < answers.size(); ++i) {
      ASSERT_TRUE(test::same_bits(answers[i], asked.answers[i]));
      ASSERT_TRUE(test::same_bits(distances[i], asked.answers[i].distance));
    }
  }
}

}  // namespace
}  // namespace cdfr
