#include "geometry/segment_crossings.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "support/meshes.h"
#include "support/random.h"
#include "support/winding.h"

namespace cdfr {
namespace {

using Corners = std::array<Vec3, 3>;

/// Lanes beyond the corners given repeat the last ones. Normals only have to tell who has an area.
TriangleGroup group_of(const std::vector<Corners>& triangles) {
  TriangleGroup group;
  for (std::size_t lane = 0; lane < group_size; ++lane) {
    const Corners& t = triangles[std::min(lane, triangles.size() - 1)];
    for (std::size_t k = 0; k < 3; ++k) {
      group.vertices[k][0][lane] = t[k].x;
      group.vertices[k][1][lane] = t[k].y;
      group.vertices[k][2][lane] = t[k].z;
    }
    for (auto& axis : group.normals) axis[lane] = 1;
  }
  return group;
}

std::optional<int> crossings(const Vec3& p, const Vec3& q, const std::vector<Corners>& triangles) {
  SegmentCrossings crossings(p, q);
  for (std::size_t first = 0; first < triangles.size(); first += group_size) {
    const std::size_t end = std::min(first + group_size, triangles.size());
    const std::vector<Corners> part(triangles.begin() + static_cast<std::ptrdiff_t>(first),
                                    triangles.begin() + static_cast<std::ptrdiff_t>(end));
    if (!crossings.add(group_of(part), (1U << part.size()) - 1)) return std::nullopt;
  }
  return crossings.total();
}

/// Exact for small whole numbers.
double side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 e{b.x - a.x, b.y - a.y, b.z - a.z}, f{c.x - a.x, c.y - a.y, c.z - a.z};
  const Vec3 r{p.x - a.x, p.y - a.y, p.z - a.z};
  return (e.y * f.z - e.z * f.y) * r.x + (e.z * f.x - e.x * f.z) * r.y + (e.x * f.y - e.y * f.x) * r.z;
}

TEST(SegmentCrossings, AreExactAmongWholeNumbers) {
  test::Random random(1);
  const auto whole = [&] {
    const auto x = [&] { return static_cast<double>(random.below(6)); };
    return Vec3{x(), x(), x()};
  };
  int passing = 0, open = 0;
  for (int i = 0; i < 200000; ++i) {
    const Vec3 p = whole(), q = whole();
    const Corners t{whole(), whole(), whole()};
    const double from = side(t[0], t[1], t[2], p), to = side(t[0], t[1], t[2], q);
    const double e[3] = {side(p, t[0], t[1], q), side(p, t[1], t[2], q), side(p, t[2], t[0], q)};
    const bool leaves = from < 0 && to > 0 && e[0] > 0 && e[1] > 0 && e[2] > 0;
    const bool enters = from > 0 && to < 0 && e[0] < 0 && e[1] < 0 && e[2] < 0;
    const bool some_positive = e[0] > 0 || e[1] > 0 || e[2] > 0;
    const bool some_negative = e[0] < 0 || e[1] < 0 || e[2] < 0;
    const bool apart = from * to > 0 || (some_positive && some_negative);
    const std::optional<int> counted = crossings(p, q, {t});
    ASSERT_EQ(counted.has_value(), leaves || enters || apart) << i;
    ASSERT_EQ(counted.value_or(0), leaves ? 1 : enters ? -1 : 0) << i;
    passing += leaves || enters;
    open += !counted.has_value();
  }
  EXPECT_GT(passing, 1000);
  EXPECT_GT(open, 1000);
}

TEST(SegmentCrossings, OfAClosedMeshAreTheDifferenceOfItsWindingNumbers) {
  const Mesh mesh = test::sphere_mesh(2);
  std::vector<Corners> triangles;
  for (const Triangle& t : mesh.triangles)
    triangles.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.in({{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}});
    const Vec3 q = random.in({{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}});
    const double difference = test::brute_winding(mesh.view(), p) - test::brute_winding(mesh.view(), q);
    EXPECT_NEAR(crossings(p, q, triangles).value(), difference, 1e-9);
  }
}

TEST(SegmentCrossings, EndsAnUlpFromAFaceAreToldApart) {
  const Corners t{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  const double third = 0.25, above = 0x1p-54;  // 0.25 + 0.25 + 0.5 is on the plane
  const Vec3 inside{third, third, 0.5 - above}, outside{third, third, 0.5 + 2 * above};
  EXPECT_EQ(crossings(inside, outside, {t}), 1);
  EXPECT_EQ(crossings(outside, inside, {t}), -1);
  EXPECT_EQ(crossings(inside, {third, third, 0.5}, {t}), std::nullopt);
}

TEST(SegmentCrossings, LanesLeftOutAndTrianglesOfNoAreaDoNotCount) {
  TriangleGroup group = group_of({{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}}});
  SegmentCrossings none({1, 1, -1}, {1, 1, 1});
  EXPECT_TRUE(none.add(group, 0));
  EXPECT_EQ(none.total(), 0);
  SegmentCrossings three({1, 1, -1}, {1, 1, 1});
  EXPECT_TRUE(three.add(group, 0x31));
  EXPECT_EQ(three.total(), 3);
  group = group_of({{Vec3{0, 0, 0}, Vec3{2, 2, 0}, Vec3{4, 4, 0}}});
  for (auto& axis : group.normals) std::fill_n(axis, group_size, 0.0);
  SegmentCrossings flat({1, 1, -1}, {1, 1, 1});
  EXPECT_TRUE(flat.add(group, 0xff));
  EXPECT_EQ(flat.total(), 0);
}

}  // namespace
}  // namespace cdfr
