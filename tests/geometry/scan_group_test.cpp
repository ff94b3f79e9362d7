#include "geometry/scan_group.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "geometry/scan_cases.h"

namespace cdfr {
namespace {

using Real = long double;
using test::ShapedGroup;

constexpr Vec3 origin{-2.5, 1024.25, 0.125};
constexpr double edge = 0.5;

/// What a double rounds off a vertex minus the origin, in edges.
constexpr Real rounded_away = 0x1p-42L;

/// A vertex in edges from the lattice's origin.
std::array<Real, 3> true_vertex(const TriangleGroup& group, std::size_t corner, std::size_t lane) {
  const Vec3 v = group.vertex(corner, lane);
  return {(Real{v.x} - Real{origin.x}) / edge, (Real{v.y} - Real{origin.y}) / edge,
          (Real{v.z} - Real{origin.z}) / edge};
}

std::array<Real, 3> kept_vertex(const ScanGroup& scan, std::size_t corner, std::size_t lane) {
  std::array<Real, 3> v;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    v[axis] = Real{scan.origin[axis]} + Real{scan.unit} * scan.vertices[corner][axis][lane];
  }
  return v;
}

Real between(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

Real widest(const TriangleGroup& group) {
  Real most = 0;
  for (std::size_t i = 0; i < 3 * group_size; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      most = std::max(most, between(true_vertex(group, i / group_size, i % group_size),
                                    true_vertex(group, k / group_size, k % group_size)));
    }
  }
  return most;
}

/// Calls f with groups of every shape, 2^-40 (below 1e-12) to 8 edges in size, anywhere in the brick.
template <class F>
void with_groups(std::uint64_t seed, F f) {
  test::Random random(seed);
  for (int i = 0; i < 3000; ++i) {
    const double size = 4 * edge * std::ldexp(1.0, -static_cast<int>(random.below(43)));
    const double room = 8 * edge - 2 * size;
    const auto at = [&](double from) { return from + size + random.between(0, room); };
    const Vec3 middle{at(origin.x), at(origin.y), at(origin.z)};
    f(test::shaped_group(random, test::all_shapes[i % 6], middle, size).group);
  }
}

TEST(ScanGroup, KeepsVerticesToHalfAUnitAnAxis) {
  with_groups(1, [](const TriangleGroup& group) {
    const ScanGroup scan = scan_group(group, origin, edge);
    const Real most = std::sqrt(3.0L) / 2 * scan.unit * (1 + 0x1p-30L) + rounded_away;
    for (std::size_t i = 0; i < 3 * group_size; ++i) {
      const std::size_t corner = i / group_size, lane = i % group_size;
      ASSERT_LE(between(true_vertex(group, corner, lane), kept_vertex(scan, corner, lane)), most);
    }
  });
}

TEST(ScanGroup, ReachBoundsTheDistanceOfAnyTwoVertices) {
  with_groups(2, [](const TriangleGroup& group) {
    ASSERT_GE(scan_group(group, origin, edge).reach() + rounded_away, widest(group));
  });
}

TEST(ScanGroup, ReachOfAGroupNotFarAwayIsAtMostTwiceTheDistanceOfItsVertices) {
  test::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const double size = edge * std::ldexp(1.0, -static_cast<int>(random.below(10)));
    const Vec3 middle{origin.x + size, origin.y + size, origin.z + size};
    const ShapedGroup made = test::shaped_group(random, test::Shapes::any, middle, size);
    ASSERT_LE(scan_group(made.group, origin, edge).reach(), 2 * widest(made.group));
  }
}

TEST(ScanGroup, AMillionSizesFromTheOriginCostsLessThanAnEighthOfTheSize) {
  test::Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const double size = 4e-6 * edge;
    const Vec3 middle{origin.x + 4 * edge, origin.y + 4 * edge, origin.z + 4 * edge};
    const TriangleGroup group = test::shaped_group(random, test::Shapes::any, middle, size).group;
    const ScanGroup scan = scan_group(group, origin, edge);
    ASSERT_GE(scan.reach(), widest(group));
    ASSERT_LE(scan.unit * 32767.0, 1.125 * size / edge);
  }
}

TEST(ScanGroup, OnePointHasTheLeastUnit) {
  ShapedGroup made;
  for (std::size_t lane = 0; lane < group_size; ++lane) test::put(made, lane, {origin, origin, origin});
  const ScanGroup scan = scan_group(made.group, origin, edge);
  EXPECT_EQ(scan.unit, std::nextafter(0x1p-56F, 1.0F));
  EXPECT_EQ(kept_vertex(scan, 2, 7), (std::array<Real, 3>{0, 0, 0}));
}

TEST(ScanGroup, NormalsAreRoundedAndZeroWithoutArea) {
  test::Random random(5);
  const ShapedGroup flat = test::shaped_group(random, test::Shapes::segments, origin, 1);
  const ShapedGroup made = test::shaped_group(random, test::Shapes::needles, origin, 1);
  const ScanGroup none = scan_group(flat.group, origin, edge), some = scan_group(made.group, origin, edge);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      EXPECT_EQ(none.normals[axis][lane], 0);
      EXPECT_EQ(some.normals[axis][lane], static_cast<float>(made.group.normals[axis][lane]));
    }
  }
}

TEST(ScanGroup, IsTheSameForAMeshScaledByAPowerOfTwo) {
  with_groups(6, [](const TriangleGroup& group) {
    TriangleGroup larger = group;
    for (auto& corner : larger.vertices) {
      for (auto& axis : corner) {
        for (double& x : axis) x = std::ldexp(x, 60);
      }
    }
    const Vec3 far{std::ldexp(origin.x, 60), std::ldexp(origin.y, 60), std::ldexp(origin.z, 60)};
    const ScanGroup a = scan_group(group, origin, edge), b = scan_group(larger, far, std::ldexp(edge, 60));
    ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0);
  });
}

}  // namespace
}  // namespace cdfr
