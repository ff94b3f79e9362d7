#include "geometry/triangle_contact.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "geometry/exact_contact.h"
#include "geometry/planar_orientation.h"
#include "geometry/unit_normal.h"
#include "support/random.h"

namespace cdfr {
namespace {

using Pair = std::array<ContactTriangle, 2>;

/// Corners at one place get one number.
Pair welded(const std::array<Vec3, 6>& places) {
  Pair pair{};
  for (std::uint32_t i = 0; i < 6; ++i) {
    std::uint32_t number = i;
    while (number > 0 && places[number - 1] != places[i]) --number;
    pair[i / 3].corners[i % 3] = places[i];
    pair[i / 3].vertices[i % 3] = number == 0 ? i + 1 : number;
  }
  return pair;
}

ContactTriangle with_normal(ContactTriangle triangle) {
  const auto& c = triangle.corners;
  triangle.normal = rounded(unit_normal(c[0], c[1], c[2]));
  return triangle;
}

/// Asked from both sides, with normals and without, and for every order of the corners: none of it matters.
bool meet_both_ways(const Pair& pair) {
  const bool answer = ContactProbe(pair[0]).meets(pair[1]);
  EXPECT_EQ(ContactProbe(with_normal(pair[0])).meets(with_normal(pair[1])), answer);
  for (int turn = 0; turn < 3; ++turn) {
    for (const bool mirrored : {false, true}) {
      ContactTriangle other = pair[1];
      std::rotate(other.corners.begin(), other.corners.begin() + turn, other.corners.end());
      std::rotate(other.vertices.begin(), other.vertices.begin() + turn, other.vertices.end());
      if (mirrored) {
        std::swap(other.corners[0], other.corners[1]);
        std::swap(other.vertices[0], other.vertices[1]);
      }
      EXPECT_EQ(ContactProbe(pair[0]).meets(other), answer);
      EXPECT_EQ(ContactProbe(other).meets(pair[0]), answer);
      EXPECT_EQ(ContactProbe(with_normal(other)).meets(with_normal(pair[0])), answer);
    }
  }
  return answer;
}

bool meet(const std::array<Vec3, 6>& places) { return meet_both_ways(welded(places)); }

int common_vertices(const Pair& pair) {
  int common = 0;
  for (const std::uint32_t a : pair[0].vertices) {
    for (const std::uint32_t b : pair[1].vertices) common += a == b;
  }
  return common;
}

Vec3 scaled(const Vec3& p, double factor) { return {p.x * factor, p.y * factor, p.z * factor}; }

void expect_oracle(const std::array<Vec3, 6>& places) {
  const Pair pair = welded(places);
  const bool expected = test::meet_exactly(pair[0], pair[1]);
  EXPECT_EQ(meet_both_ways(pair), expected);
  for (const double factor : {0x1p-200, 0x1p190}) {
    std::array<Vec3, 6> other = places;
    for (Vec3& p : other) p = scaled(p, factor);
    EXPECT_EQ(ContactProbe(welded(other)[0]).meets(welded(other)[1]), expected) << factor;
  }
}

/// How often each number of common vertices came, and how often with a contact.
struct Counts {
  std::array<int, 4> pairs{}, contacts{};
  void count(const std::array<Vec3, 6>& places) {
    const Pair pair = welded(places);
    if (test::has_no_area(pair[0].corners) || test::has_no_area(pair[1].corners)) return;
    const int common = common_vertices(pair);
    ++pairs[common];
    contacts[common] += ContactProbe(pair[0]).meets(pair[1]);
  }
};

Vec3 lattice_point(test::Random& random, std::uint64_t size) {
  const auto c = [&] { return static_cast<double>(random.below(size)) - static_cast<double>(size / 2); };
  return {c(), c(), c()};
}

TEST(TriangleContact, AgreesWithRationalsOnALattice) {
  test::Random random(11);
  Counts counts;
  for (int i = 0; i < 4000; ++i) {
    std::array<Vec3, 6> p;
    for (Vec3& v : p) v = lattice_point(random, 3 + i % 3);
    ASSERT_NO_FATAL_FAILURE(expect_oracle(p));
    counts.count(p);
  }
  for (int common = 0; common < 3; ++common) {
    EXPECT_GT(counts.pairs[common], 30) << common;
    EXPECT_GT(counts.contacts[common], 0) << common;
  }
}

TEST(TriangleContact, AgreesWithRationalsInAndNearAPlane) {
  test::Random random(12);
  Counts counts;
  for (int i = 0; i < 4000; ++i) {
    std::array<Vec3, 6> p;
    for (Vec3& v : p) {
      v = lattice_point(random, 5);
      v.z = v.x + 2 * v.y;
    }
    if (i % 3 == 0) p[random.below(6)].z += random.below(2) == 0 ? 1 : 0x1p-40;
    ASSERT_NO_FATAL_FAILURE(expect_oracle(p));
    counts.count(p);
  }
  for (int common = 0; common < 3; ++common) {
    EXPECT_GT(counts.pairs[common], 50) << common;
    EXPECT_GT(counts.contacts[common], 20) << common;
    EXPECT_GT(counts.pairs[common] - counts.contacts[common], 20) << common;
  }
}

TEST(TriangleContact, AgreesWithRationalsAnUlpFromTouching) {
  test::Random random(13);
  int contacts = 0;
  for (int i = 0; i < 3000; ++i) {
    std::array<Vec3, 6> p;
    for (Vec3& v : p) v = random.in({{0.1, 0.2, 0.3}, {1, 1, 1}});
    // A corner of the second on the first, as well as rounding lets it be there; the rest beyond or in it.
    const double s = random.between(0, 1), t = i % 3 == 0 ? 1 - s : random.between(0, 1 - s);
    const auto on = [&](double a, double b, double c) { return a + s * (b - a) + t * (c - a); };
    p[3] = {on(p[0].x, p[1].x, p[2].x), on(p[0].y, p[1].y, p[2].y), on(p[0].z, p[1].z, p[2].z)};
    if (i % 2 == 0) p[4] = p[2];
    const Pair pair = welded(p);
    const bool expected = test::meet_exactly(pair[0], pair[1]);
    ASSERT_EQ(meet_both_ways(pair), expected);
    contacts += expected;
  }
  EXPECT_GT(contacts, 300);
  EXPECT_LT(contacts, 2700);
}

TEST(TriangleContact, AgreesWithRationalsOnNeedles) {
  test::Random random(14);
  int contacts = 0;
  for (int i = 0; i < 3000; ++i) {
    std::array<Vec3, 6> p;
    for (int k = 0; k < 6; k += 3) {
      const Vec3 a = random.in({{-1, -1, -1}, {1, 1, 1}}), b = random.in({{-1, -1, -1}, {1, 1, 1}});
      const double width = i % 2 == 0 ? 0x1p-50 : 0x1p-30;
      p[k] = a;
      p[k + 1] = b;
      p[k + 2] = {(a.x + b.x) / 2 + width, (a.y + b.y) / 2, (a.z + b.z) / 2 - width};
    }
    if (i % 4 == 1) p[3] = {(p[0].x + p[1].x) / 2, (p[0].y + p[1].y) / 2, (p[0].z + p[1].z) / 2};
    if (i % 4 == 2) p[4] = p[0];
    if (i % 4 == 3) p[3] = p[0], p[4] = p[1];
    const Pair pair = welded(p);
    const bool expected = test::meet_exactly(pair[0], pair[1]);
    ASSERT_EQ(meet_both_ways(pair), expected);
    contacts += expected;
  }
  EXPECT_GT(contacts, 20);
}

TEST(TriangleContact, NoVertexInCommonTouchingCounts) {
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  EXPECT_TRUE(meet({a, b, c, {1, 1, 0}, {1, 1, 3}, {2, 1, 3}}));      // a corner in the face
  EXPECT_TRUE(meet({a, b, c, {2, 0, 0}, {2, -1, 3}, {2, -3, 1}}));    // a corner on an edge
  EXPECT_TRUE(meet({a, b, c, {2, -1, 1}, {2, 1, -1}, {2, -3, -3}}));  // two edges in a point
  EXPECT_TRUE(meet({a, b, c, {1, 1, 0}, {2, 1, 0}, {1, 1, 5}}));      // an edge in the face
  EXPECT_TRUE(meet({a, b, c, {-1, 1, 0}, {5, 1, 0}, {1, 1, 5}}));     // an edge across the face
  EXPECT_TRUE(meet({a, b, c, {1, 1, -1}, {1, 1, 1}, {9, 9, 0}}));     // through it
  EXPECT_FALSE(meet({a, b, c, {1, 1, 0x1p-40}, {1, 1, 3}, {2, 1, 3}}));
  EXPECT_FALSE(meet({a, b, c, {3, 2, 0}, {3, 2, 3}, {2, 3, 3}}));  // in the plane, beside it
  EXPECT_FALSE(meet({a, b, c, {0, 0, 1}, {4, 0, 1}, {0, 4, 1}}));  // parallel
}

TEST(TriangleContact, InOnePlane) {
  const Vec3 a{0, 0, 0}, b{8, 0, 0}, c{0, 8, 0};
  EXPECT_TRUE(meet({a, b, c, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}));    // one in the other
  EXPECT_TRUE(meet({a, b, c, {4, 4, 0}, {9, 4, 0}, {9, 9, 0}}));    // a corner on an edge
  EXPECT_TRUE(meet({a, b, c, {2, 0, 0}, {6, 0, 0}, {4, -3, 0}}));   // edges along one another
  EXPECT_TRUE(meet({a, b, c, {-1, 3, 0}, {9, 3, 0}, {-1, 2, 0}}));  // across, no corner in the other
  EXPECT_FALSE(meet({a, b, c, {9, 0, 0}, {12, 0, 0}, {9, 3, 0}}));  // in line
  EXPECT_FALSE(meet({a, b, c, {5, 4, 0}, {9, 4, 0}, {9, 9, 0}}));
}

TEST(TriangleContact, OneVertexInCommon) {
  const Vec3 v{0, 0, 0}, a{4, 0, 0}, b{0, 4, 0};
  EXPECT_FALSE(meet({v, a, b, v, {1, 1, 2}, {2, 1, 3}}));
  EXPECT_FALSE(meet({v, a, b, v, {-1, 0, 0}, {0, -1, 0}}));  // opposite in one plane
  EXPECT_FALSE(meet({v, a, b, v, {-4, 0, 0}, {-1, 3, 0}}));  // edges in line, away from each other
  EXPECT_TRUE(meet({v, a, b, v, {2, 0, 0}, {0, -1, 0}}));    // an edge along an edge
  EXPECT_TRUE(meet({v, a, b, v, {8, 0, 0}, {8, 0, 5}}));
  EXPECT_TRUE(meet({v, a, b, v, {1, 1, 0}, {1, 1, 5}}));   // an edge in the face
  EXPECT_TRUE(meet({v, a, b, v, {9, 9, 1}, {9, 9, -1}}));  // through it, from the corner on
  EXPECT_TRUE(meet({v, a, b, v, {2, 1, 0}, {1, 2, 0}}));   // over one another
}

TEST(TriangleContact, AnEdgeInCommonIsAContactOnlyIfFoldedFlat) {
  const Vec3 u{0, 0, 0}, v{4, 0, 0}, apex{1, 3, 0};
  EXPECT_FALSE(meet({u, v, apex, u, v, {1, -3, 0}}));
  EXPECT_FALSE(meet({u, v, apex, u, v, {1, 3, 1}}));
  EXPECT_FALSE(meet({u, v, apex, u, v, {1, 3, 0x1p-190}}));
  EXPECT_TRUE(meet({u, v, apex, u, v, {1, 4, 0}}));
  EXPECT_TRUE(meet({u, v, apex, u, v, {9, 1, 0}}));
}

TEST(TriangleContact, DuplicatesAndTrianglesOfNoAreaAreNone) {
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  EXPECT_FALSE(meet({a, b, c, b, c, a}));
  EXPECT_FALSE(meet({a, b, c, b, a, c}));
  EXPECT_FALSE(meet({a, b, c, {0, 0, -1}, {0, 0, 0}, {0, 0, 1}}));
  EXPECT_FALSE(meet({a, b, c, {1, 1, -1}, {1, 1, 1}, {1, 1, 3}}));
  EXPECT_FALSE(meet({a, b, c, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}}));
  EXPECT_FALSE(meet({a, b, c, {1, 1, 0}, {2, 1, 0}, {1, 1, 0}}));
  EXPECT_FALSE(ContactProbe({{a, {1, 1, 1}, {2, 2, 2}}, {0, 1, 2}}).has_area());
  EXPECT_TRUE(ContactProbe({{a, {1, 1, 1}, {2, 2, std::nextafter(2, 3)}}, {0, 1, 2}}).has_area());
}

TEST(TriangleContact, EqualPlacesOfDifferentVerticesTouch) {
  const ContactTriangle a{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}, {0, 1, 2}};
  ContactTriangle b{{Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 1}}, {0, 3, 4}};
  EXPECT_FALSE(ContactProbe(a).meets(b));
  b.vertices[0] = 5;
  EXPECT_TRUE(ContactProbe(a).meets(b));
}

TEST(SegmentTriangle, AgreesWithRationals) {
  test::Random random(15);
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    std::array<Vec3, 5> p;
    for (Vec3& v : p) {
      v = lattice_point(random, 5);
      if (i % 2 == 0) v.z = 3 * v.x - v.y;
    }
    if (test::has_no_area({p[0], p[1], p[2]}) || p[3] == p[4]) continue;
    const bool expected = !test::common_points({p[3], p[4], p[4]}, {p[0], p[1], p[2]}).empty();
    ASSERT_EQ(segment_meets_triangle({p[3], p[4]}, {p[0], p[1], p[2]}), expected);
    ASSERT_EQ(segment_meets_triangle({p[4], p[3]}, {p[1], p[0], p[2]}), expected);
    met += expected;
  }
  EXPECT_GT(met, 500);
}

TEST(PlanarOrientation, AgreesWithRationals) {
  test::Random random(16);
  int flat = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<Vec3, 3> p;
    for (Vec3& v : p) v = lattice_point(random, 5);
    // Nearly in line: multiples of numbers that are no dyadic fractions.
    if (i % 2 == 0) {
      for (Vec3& v : p) v = {v.x * 0.1, v.x * 0.3, v.x * 0.7};
    }
    const double factor = i % 3 == 0 ? 1 : (i % 3 == 1 ? 0x1p-195 : 0x1p195);
    const test::Rational3 normal = test::cross(test::minus(test::exact(p[1]), test::exact(p[0])),
                                               test::minus(test::exact(p[2]), test::exact(p[0])));
    for (Vec3& v : p) v = scaled(v, factor);
    for (int axis = 0; axis < 3; ++axis) {
      const PlanarPoint a = seen_along(axis, p[0]), b = seen_along(axis, p[1]), c = seen_along(axis, p[2]);
      ASSERT_EQ(planar_orientation(a, b, c), sgn(normal[static_cast<std::size_t>(axis)]));
    }
    flat += sgn(normal[0]) == 0;
  }
  EXPECT_GT(flat, 1000);
}

}  // namespace
}  // namespace cdfr
