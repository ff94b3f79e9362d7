#include "geometry/triangle_group.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "geometry/point_triangle.h"
#include "geometry/unit_normal.h"
#include "support/random.h"

namespace cdfr {
namespace {

struct Case {
  TriangleGroup group;
  std::array<TriangleShape, group_size> shapes;
};

/// Corners in the box, then flattened towards a needle or a cap by a random power of two.
Case random_case(test::Random& random) {
  Case c;
  for (std::size_t lane = 0; lane < group_size; ++lane) {
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    Vec3 a = random.in(box), b = random.in(box), d = random.in(box);
    const double flat = std::ldexp(1.0, -static_cast<int>(random.below(60)));
    const double t = random.between(-0.2, 1.2);
    const Vec3 on{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
    d = {on.x + flat * d.x, on.y + flat * d.y, on.z + flat * d.z};
    c.shapes[lane] = {{a, b, d}, unit_normal(a, b, d)};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3& v = c.shapes[lane].vertices[corner];
      c.group.vertices[corner][0][lane] = v.x;
      c.group.vertices[corner][1][lane] = v.y;
      c.group.vertices[corner][2][lane] = v.z;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) c.group.normals[axis][lane] = c.shapes[lane].normal[axis].hi;
  }
  return c;
}

/// A query anywhere, or close to the plane or an edge of one of the triangles.
Vec3 random_query(test::Random& random, const Case& c) {
  const Vec3 p = random.in({{-2, -2, -2}, {2, 2, 2}});
  const TriangleShape& t = c.shapes[random.below(group_size)];
  const double s = random.between(-0.5, 1.5), r = random.below(2) == 0 ? 0 : random.between(-0.5, 1.5);
  const double off = std::ldexp(1.0, -static_cast<int>(random.below(60)));
  const auto on = [&](double a, double b, double d, double e) {
    return a + s * (b - a) + r * (d - a) + off * e;
  };
  const Vec3 &a = t.vertices[0], &b = t.vertices[1], &d = t.vertices[2];
  if (random.below(3) == 0) return p;
  return {on(a.x, b.x, d.x, p.x), on(a.y, b.y, d.y, p.y), on(a.z, b.z, d.z, p.z)};
}

double reach(const Vec3& p, const TriangleShape& t) {
  double largest = 0;
  for (const Vec3& v : t.vertices) largest = std::max(largest, std::hypot(p.x - v.x, p.y - v.y, p.z - v.z));
  return largest;
}

TEST(TriangleGroup, EstimatesStayWithinTheirBoundAtAnyAspect) {
  test::Random random(8);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Case c = random_case(random);
    const Vec3 p = random_query(random, c);
    GroupDistances squared;
    estimate_squared(p, c.group, squared);
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      const double exact = square_root(measure(p, c.shapes[lane]).squared);
      const double error = std::fabs(std::sqrt(squared[lane]) - exact) / reach(p, c.shapes[lane]);
      worst = std::max(worst, error);
      ASSERT_LE(error, estimate_error);
      const Vec3 q = estimate_closest(p, c.group, lane);
      ASSERT_LE(square_root(measure(q, c.shapes[lane]).squared), estimate_error * reach(p, c.shapes[lane]));
    }
  }
  RecordProperty("worst_in_u", std::to_string(worst / unit_roundoff));
}

TEST(TriangleGroup, EveryInstructionSetGivesTheSameBytes) {
  test::Random random(9);
  std::vector<Case> cases;
  std::vector<Vec3> queries;
  for (int i = 0; i < 500; ++i) {
    cases.push_back(random_case(random));
    queries.push_back(random_query(random, cases.back()));
  }
  const auto all = [&] {
    std::vector<double> results;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      GroupDistances squared;
      estimate_squared(queries[i], cases[i].group, squared);
      results.insert(results.end(), squared.begin(), squared.end());
      const Vec3 q = estimate_closest(queries[i], cases[i].group, i % group_size);
      results.insert(results.end(), {q.x, q.y, q.z});
    }
    return results;
  };
  const std::vector<double> expected = all();
  int sets = 0;
  for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    hwy::SetSupportedTargetsForTest(targets & -targets);
    const std::vector<double> results = all();
    ++sets;
    EXPECT_EQ(std::memcmp(results.data(), expected.data(), expected.size() * sizeof(double)), 0)
        << hwy::TargetName(targets & -targets);
  }
  hwy::SetSupportedTargetsForTest(0);
  EXPECT_GE(sets, 1);
}

}  // namespace
}  // namespace cdfr
