/// The oracle's own tests: what it says of points and triangles that can be worked out by hand or in another
/// way.
#include "oracle/exact_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "oracle/candidates.h"
#include "oracle/random.h"

namespace cdfr::oracle {
namespace {

/// Numerator over denominator in lowest terms, exponent folded in: equal values print the same.
mpq_class value(const Ratio& ratio) {
  mpq_class result(ratio.numerator, ratio.denominator);
  result.canonicalize();
  if (ratio.exponent >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(ratio.exponent));
  } else {
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-ratio.exponent));
  }
  return result;
}

constexpr Vec3 a{0, 0, 0};
constexpr Vec3 b{4, 0, 0};
constexpr Vec3 c{0, 3, 0};

TEST(ExactDistance, is_what_hand_computation_says_in_each_region) {
  EXPECT_EQ(value(exact_distance({1, 1, 5}, a, b, c).squared), 25);
  EXPECT_EQ(value(exact_distance({1, 1, -5}, a, b, c).squared), 25);
  EXPECT_EQ(value(exact_distance({2, -2, 1}, a, b, c).squared), 5);
  EXPECT_EQ(value(exact_distance({-1, 1, 2}, a, b, c).squared), 5);
  EXPECT_EQ(value(exact_distance({-1, -2, 2}, a, b, c).squared), 9);
  EXPECT_EQ(value(exact_distance({6, -1, 0}, a, b, c).squared), 5);
  EXPECT_EQ(value(exact_distance({-1, 5, 0}, a, b, c).squared), 5);
  // The long side 3x + 4y = 12: (4, 3) is 12/5 above it.
  EXPECT_EQ(value(exact_distance({4, 3, 0}, a, b, c).squared), mpq_class(144, 25));
  EXPECT_EQ(value(exact_distance({4, 3, 1}, a, b, c).squared), mpq_class(169, 25));
}

TEST(ExactDistance, foot_is_what_hand_computation_says) {
  const Exact face = exact_distance({1, 1, 5}, a, b, c);
  EXPECT_EQ(value(face.foot[0]), 1);
  EXPECT_EQ(value(face.foot[1]), 1);
  EXPECT_EQ(value(face.foot[2]), 0);
  const Exact edge = exact_distance({4, 3, 7}, a, b, c);
  EXPECT_EQ(value(edge.foot[0]), mpq_class(64, 25));
  EXPECT_EQ(value(edge.foot[1]), mpq_class(27, 25));
  EXPECT_EQ(edge.foot_error_in_ulps({2.56, 1.08, 0}, {4, 3, 7}, 4) < 1, true);
}

TEST(ExactDistance, is_zero_on_the_triangle_and_on_nothing_beside_it) {
  EXPECT_EQ(value(exact_distance(a, a, b, c).squared), 0);
  EXPECT_EQ(value(exact_distance({2, 1.5, 0}, a, b, c).squared), 0);
  EXPECT_EQ(value(exact_distance({1, 0, 0}, a, b, c).squared), 0);
  EXPECT_GT(value(exact_distance({1, -5e-324, 0}, a, b, c).squared), 0);
  EXPECT_GT(value(exact_distance({1, 1, 5e-324}, a, b, c).squared), 0);
  const double above = std::nextafter(1.5, 2.0);
  EXPECT_GT(value(exact_distance({2, above, 0}, a, b, c).squared), 0);
}

TEST(ExactDistance, takes_triangles_of_no_area_for_segments_and_points) {
  EXPECT_EQ(value(exact_distance({2, 3, 0}, a, b, {2, 0, 0}).squared), 9);
  EXPECT_EQ(value(exact_distance({7, 4, 0}, {2, 0, 0}, b, a).squared), 25);
  EXPECT_EQ(value(exact_distance({2, 3, 0}, a, b, b).squared), 9);
  EXPECT_EQ(value(exact_distance({2, 3, 0}, b, b, b).squared), 13);
  EXPECT_EQ(value(exact_distance({0, 0, 0}, a, a, a).squared), 0);
}

TEST(ExactDistance, bears_the_most_extreme_coordinates) {
  const double big = 0x1p200;
  const double small = 0x1p-200;
  const Exact far = exact_distance({0, 0, big}, {small, 0, 0}, {0, small, 0}, {-small, -small, 0});
  EXPECT_EQ(far.error_in_ulps(big, {0, 0, big}, small), 0);
  const Exact near = exact_distance({small, small, small}, {-big, -big, 0}, {big, -big, 0}, {0, big, 0});
  EXPECT_EQ(value(near.squared), value({1, 1, -400}));
  const Exact tiny = exact_distance({5e-324, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1});
  EXPECT_EQ(value(tiny.squared), value({1, 1, -2148}));
}

TEST(ExactDistance, does_not_depend_on_the_order_of_the_corners) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    std::array<Vec3, 3> v{random.direction(), random.direction(), random.direction()};
    if (i % 4 == 0) v[2] = {(v[0].x + v[1].x) / 2, (v[0].y + v[1].y) / 2, (v[0].z + v[1].z) / 2};
    const Vec3 d = random.direction();
    const Vec3 p{1.5 * d.x, 1.5 * d.y, 1.5 * d.z};
    const Exact first = exact_distance(p, v[0], v[1], v[2]);
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
      const Exact other = exact_distance(p, v[order[0]], v[order[1]], v[order[2]]);
      EXPECT_EQ(compare(first.squared, other.squared), 0);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(compare(first.foot[k], other.foot[k]), 0);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(ExactDistance, scales_with_powers_of_two) {
  Random random(2);
  for (const int shift : {-200, -53, -1, 1, 53, 199}) {
    const auto scaled = [&](Vec3 v) {
      return Vec3{std::ldexp(v.x, shift), std::ldexp(v.y, shift), std::ldexp(v.z, shift)};
    };
    const Vec3 p = random.direction();
    const std::array<Vec3, 3> v{random.direction(), random.direction(), random.direction()};
    Ratio expected = exact_distance(p, v[0], v[1], v[2]).squared;
    expected.exponent += 2 * shift;
    const Exact result = exact_distance(scaled(p), scaled(v[0]), scaled(v[1]), scaled(v[2]));
    EXPECT_EQ(compare(result.squared, expected), 0) << shift;
  }
}

TEST(ExactDistance, squared_distance_is_that_of_the_foot) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const std::array<Vec3, 3> v{random.direction(), random.direction(), random.direction()};
    const Vec3 p = random.direction();
    const Exact exact = exact_distance(p, v[0], v[1], v[2]);
    const mpq_class x = value(exact.foot[0]) - p.x;
    const mpq_class y = value(exact.foot[1]) - p.y;
    const mpq_class z = value(exact.foot[2]) - p.z;
    EXPECT_EQ(value(exact.squared), mpq_class(x * x + y * y + z * z));
  }
}

using Long = long double;
struct LongVector {
  Long x, y, z;
};
Long dot(LongVector u, LongVector v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
LongVector along(LongVector u, Long t, LongVector v) { return {u.x + t * v.x, u.y + t * v.y, u.z + t * v.z}; }

/// Without any region logic: least distance over a fine search that narrows down on the best barycentric
/// pair.
Long searched_distance(LongVector p, LongVector v, LongVector e, LongVector f) {
  Long s_best = 0, t_best = 0, best = std::numeric_limits<Long>::infinity();
  Long s_centre = 0.5L, t_centre = 0.5L;
  for (Long width = 0.5L; width > 1e-13L; width /= 4) {
    for (int i = -16; i <= 16; ++i) {
      for (int j = -16; j <= 16; ++j) {
        const Long s = std::clamp(s_centre + width * i / 16, 0.0L, 1.0L);
        const Long t = std::clamp(t_centre + width * j / 16, 0.0L, 1.0L - s);
        const LongVector d = along(along(along(v, s, e), t, f), -1, p);
        if (dot(d, d) < best) best = dot(d, d), s_best = s, t_best = t;
      }
    }
    s_centre = s_best, t_centre = t_best;
  }
  return std::sqrt(best);
}

TEST(ExactDistance, agrees_with_a_plain_search_on_friendly_triangles) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const std::array<Vec3, 3> v{random.direction(), random.direction(), random.direction()};
    const Vec3 p{2 * random.signed_unit(), 2 * random.signed_unit(), 2 * random.signed_unit()};
    const auto minus = [](Vec3 s, Vec3 t) { return LongVector{s.x - t.x, s.y - t.y, s.z - t.z}; };
    const Long expected =
        searched_distance({p.x, p.y, p.z}, {v[0].x, v[0].y, v[0].z}, minus(v[1], v[0]), minus(v[2], v[0]));
    const double found =
        exact_distance(p, v[0], v[1], v[2]).error_in_ulps(static_cast<double>(expected), p, 1);
    // The search ends on a grid of 1e-14, which moves the distance by at most as much: 64 ulp at 1.
    EXPECT_LT(found, 100) << i;
  }
}

TEST(ExactNumber, square_root_has_more_than_150_bits) {
  for (const int exponent : {-2148, -401, -1, 0, 1, 400}) {
    const Ratio square{2, 3, exponent};
    const Ratio root = square_root(square);
    const mpq_class relative = (value(square) - value(root) * value(root)) / value(square);
    EXPECT_GE(relative, 0);
    EXPECT_LT(relative, value({1, 1, -150}));
  }
  EXPECT_EQ(value(square_root({0, 7, 5})), 0);
  EXPECT_EQ(value(square_root({9, 4, 6})), 12);
}

TEST(ExactNumber, counts_ulps_at_the_largest_coordinate) {
  EXPECT_EQ(ulp_exponent(1), -52);
  EXPECT_EQ(ulp_exponent(std::nextafter(2.0, 0.0)), -52);
  EXPECT_EQ(ulp_exponent(2), -51);
  EXPECT_EQ(ulp_exponent(0), -1074);
  EXPECT_EQ(ulp_exponent(5e-324), -1074);
  const Exact five = exact_distance({0, 0, 5}, a, b, c);
  EXPECT_EQ(five.error_in_ulps(5, {0, 0, 5}, 4), 0);
  EXPECT_EQ(five.error_in_ulps(std::nextafter(5.0, 9.0), {0, 0, 5}, 4), 1);
  EXPECT_EQ(five.error_in_ulps(std::nextafter(5.0, 9.0), {0, 0, 5}, 8), 0.5);
  EXPECT_EQ(five.error_in_ulps(0, {0, 0, 5}, 4), std::ldexp(5.0, 50));
  EXPECT_TRUE(std::isinf(five.error_in_ulps(std::nan(""), {0, 0, 5}, 4)));
}

TEST(ExactDistance, orders_distances_that_no_double_tells_apart) {
  const Exact near = exact_distance({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1});
  const Exact far = exact_distance({0, 0, 0}, {1, 0x1p-500, 0}, {1, 1, 0}, {1, 0x1p-500, 1});
  EXPECT_TRUE(exact_less(near, far));
  EXPECT_FALSE(exact_less(far, near));
  EXPECT_FALSE(exact_less(near, near));
}

/// A soup of needles, caps, large and small triangles and of some without area, many of them sharing corners.
Mesh soup(Random& random, std::size_t count) {
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const double scale = random.magnitude(-30, 1);
    const Vec3 d = random.direction();
    mesh.vertices.push_back({d.x * scale, d.y * scale, d.z * scale});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto pick = [&] { return static_cast<std::uint32_t>(random.below(count)); };
    mesh.triangles.push_back({pick(), pick(), pick()});
  }
  return mesh;
}

TEST(Candidates, never_lack_the_nearest_triangle) {
  Random random(5);
  const Mesh mesh = soup(random, 150);
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  const Candidates candidates(mesh.view());
  std::size_t kept = 0;
  for (int i = 0; i < 120; ++i) {
    const double scale = random.magnitude(-40, 60);
    const Vec3 d = random.direction();
    const Vec3 v = mesh.vertices[random.below(mesh.vertices.size())];
    const Vec3 p = i % 8 == 0 ? v : Vec3{v.x + d.x * scale, v.y + d.y * scale, v.z + d.z * scale};
    const std::vector<std::uint32_t> few = candidates.near(p);
    ASSERT_FALSE(few.empty());
    kept += few.size();
    const ExactClosest expected = exact_closest(mesh.view(), p, all);
    const ExactClosest found = exact_closest(mesh.view(), p, few);
    EXPECT_EQ(found.triangle, expected.triangle);
    EXPECT_EQ(compare(found.exact.squared, expected.exact.squared), 0);
  }
  EXPECT_LT(kept, 120U * mesh.triangles.size() / 2);
}

TEST(Candidates, keep_every_one_of_equally_near_triangles) {
  Mesh mesh;
  mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  for (const std::uint32_t x : {0U, 3U}) {
    for (const std::uint32_t y : {1U, 4U}) {
      for (const std::uint32_t z : {2U, 5U}) mesh.triangles.push_back({x, y, z});
    }
  }
  EXPECT_EQ(Candidates(mesh.view()).near({0, 0, 0}).size(), 8U);
  EXPECT_EQ(exact_closest(mesh.view(), {0, 0, 0}, Candidates(mesh.view()).near({0, 0, 0})).triangle, 0U);
}

}  // namespace
}  // namespace cdfr::oracle
