#include "geometry/sample_distances.h"

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
  Samples samples;
};

/// Triangles of any aspect, many on the planes of the lattice, some without area, small, large and far away.
Case random_case(test::Random& random) {
  Case c;
  const double edge = std::ldexp(1.0, -static_cast<int>(random.below(12)));
  const auto on_lattice = [&] { return edge * (static_cast<double>(random.below(9)) - 4); };
  const Vec3 lo{on_lattice(), on_lattice(), on_lattice()};
  c.samples = Samples(lo, edge);
  for (std::size_t lane = 0; lane < group_size; ++lane) {
    const Vec3 at = random.in({{-1, -1, -1}, {1, 1, 1}});
    const double size = std::ldexp(1.0, -static_cast<int>(random.below(40)));
    const double flat = random.below(8) == 0 ? 0 : std::ldexp(1.0, -static_cast<int>(random.below(60)));
    const auto corner = [&](double t, double across) -> Vec3 {
      if (random.below(4) == 0) return {on_lattice(), on_lattice(), on_lattice()};
      return {at.x + size * (t + across), at.y + size * t, at.z + size * (t - across)};
    };
    const std::array<Vec3, 3> v{corner(0, 0), corner(random.between(0.5, 1), 0),
                                corner(random.between(-0.5, 1.5), flat)};
    c.shapes[lane] = {v, unit_normal(v[0], v[1], v[2])};
    for (std::size_t k = 0; k < 3; ++k) {
      const double xyz[3] = {v[k].x, v[k].y, v[k].z};
      for (std::size_t axis = 0; axis < 3; ++axis) c.group.vertices[k][axis][lane] = xyz[axis];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) c.group.normals[axis][lane] = c.shapes[lane].normal[axis].hi;
  }
  return c;
}

double reach(const Samples& samples, const TriangleShape& t) {
  double largest = 0;
  for (std::size_t i = 0; i < sample_count; ++i) {
    const Vec3 p = samples.point(i);
    for (const Vec3& v : t.vertices) largest = std::max(largest, std::hypot(p.x - v.x, p.y - v.y, p.z - v.z));
  }
  return largest;
}

TEST(SampleDistances, AreBelowTheTruthByNoMoreThanTheirBound) {
  test::Random random(31);
  for (int i = 0; i < 1000; ++i) {
    const Case c = random_case(random);
    SampleDistances distances;
    squared_distances_below(c.samples, c.group, distances);
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      const double m = reach(c.samples, c.shapes[lane]);
      for (std::size_t sample = 0; sample < sample_count; ++sample) {
        const DoubleDouble truth = measure(c.samples.point(sample), c.shapes[lane]).squared;
        const double below = truth.hi - distances.squared[sample][lane] + truth.lo;
        ASSERT_GE(below, 0);
        ASSERT_LE(below, 256 * unit_roundoff * m * m);
      }
    }
  }
}

TEST(SampleDistances, EveryInstructionSetGivesTheSameBytes) {
  test::Random random(32);
  std::vector<Case> cases;
  for (int i = 0; i < 300; ++i) cases.push_back(random_case(random));
  const auto all = [&] {
    std::vector<SampleDistances> results(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
      squared_distances_below(cases[i].samples, cases[i].group, results[i]);
    }
    return results;
  };
  const std::vector<SampleDistances> expected = all();
  for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    hwy::SetSupportedTargetsForTest(targets & -targets);
    const std::vector<SampleDistances> results = all();
    EXPECT_EQ(std::memcmp(results.data(), expected.data(), expected.size() * sizeof(SampleDistances)), 0)
        << hwy::TargetName(targets & -targets);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(SampleDistances, TheNearestIsTheFirstOfTheLeast) {
  test::Random random(33);
  NearestOfSamples nearest;
  nearest.clear();
  std::vector<SampleDistances> groups(20);
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    for (GroupDistances& squared : groups[g].squared) {
      for (double& value : squared) value = static_cast<double>(random.below(200));
    }
    nearest.add(groups[g], g);
  }
  for (std::size_t sample = 0; sample < sample_count; ++sample) {
    std::uint32_t best = 0;
    const auto value = [&](std::uint32_t slot) {
      return groups[slot / group_size].squared[sample][slot % 8];
    };
    for (std::uint32_t slot = 0; slot < groups.size() * group_size; ++slot) {
      if (value(slot) < value(best)) best = slot;
    }
    EXPECT_EQ(nearest.slot(sample), best);
  }
}

}  // namespace
}  // namespace cdfr
