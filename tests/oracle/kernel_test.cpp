/// Holds the library's point-triangle distance to the exact oracle, through the public face only.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "cdfr/field/field.h"
#include "oracle/claims.h"
#include "oracle/exact_distance.h"
#include "oracle/random.h"
#include "oracle/shapes.h"
#include "oracle/vectors.h"

namespace cdfr::oracle {
namespace {

constexpr std::array<Triangle, 1> one_triangle{{{0, 1, 2}}};
/// Three turns, then three the other way round.
constexpr std::array<std::array<std::size_t, 3>, 6> orders{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

Result<BruteForce> measure_to(const Corners& v) {
  return BruteForce::over({Points(std::span<const Vec3>(v)), one_triangle}, Sign::none);
}

Exact exact_to(Vec3 x, const Corners& v) { return exact_distance(x, v[0], v[1], v[2]); }

/// Counts what must not happen and keeps the first case of it, so that a broken kernel fails in one line.
class Violations {
 public:
  void add(bool violated, Vec3 x, const Corners& v) {
    if (violated && count_++ == 0) first_ = replay(x, v);
  }
  void expect_none(const char* what) const { EXPECT_EQ(count_, 0U) << what << ", first at " << first_; }

 private:
  std::size_t count_ = 0;
  std::string first_;
};

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

/// The library over a triangle in all six orders of its corners. Empty if a triangle without area was refused
/// by name.
std::vector<BruteForce> in_all_orders(const Corners& v, bool no_area) {
  std::vector<BruteForce> result;
  for (const auto& order : orders) {
    Result<BruteForce> brute = measure_to({v[order[0]], v[order[1]], v[order[2]]});
    if (brute) {
      result.push_back(*brute);
    } else if (!no_area || brute.error().code != Code::empty_mesh) {
      ADD_FAILURE() << brute.error().text << ": " << replay({}, v);
    }
  }
  return result;
}

class Kernel : public testing::TestWithParam<ShapeFamily> {
 protected:
  void measure(const std::vector<BruteForce>& brute, const Corners& v, Vec3 x, Worst& worst) {
    const Closest closest = brute[0].closest(x);
    const Errors errors = errors_of(closest, x, v, exact_to(x, v), largest_coordinate(v));
    worst.add(errors, [&] { return replay(x, v); });
    negative_.add(std::signbit(closest.distance), x, v);
    misnamed_.add(closest.triangle != 0, x, v);
    ++cases_;
    for (std::size_t i = 1; i < brute.size(); ++i) {
      const bool differs = bits(brute[i].closest(x).distance) != bits(closest.distance);
      (i < 3 ? turned_ : reversed_).add(differs, x, v);
    }
  }

  std::size_t cases_ = 0;
  Violations negative_, misnamed_, turned_, reversed_;
};

TEST_P(Kernel, keeps_its_claims) {
  constexpr int triangles = 250;
  const std::span<const QueryFamily> queries = query_families();
  std::vector<Worst> worst(queries.size());
  Random random(11);
  std::size_t refused = 0;
  for (int i = 0; i < triangles; ++i) {
    const Corners v = GetParam().make(random);
    const std::vector<BruteForce> brute = in_all_orders(v, GetParam().no_area);
    if (brute.size() < orders.size()) {
      ++refused;
      continue;
    }
    for (std::size_t k = 0; k < queries.size(); ++k) measure(brute, v, queries[k].make(random, v), worst[k]);
  }
  double distance = 0;
  for (std::size_t k = 0; k < queries.size(); ++k) {
    SCOPED_TRACE(queries[k].name);
    worst[k].expect_within_bounds();
    distance = std::max(distance, worst[k][Claim::distance]);
    std::cout << GetParam().name << " / " << queries[k].name << ": " << worst[k].text() << '\n';
  }
  RecordProperty("worst_ulp", std::to_string(distance));
  std::cout << GetParam().name << ": " << cases_ << " cases, " << refused
            << " triangles refused, worst distance " << distance << " ulp\n";
  negative_.expect_none("negative although unsigned");
  misnamed_.expect_none("another triangle than the only one");
  turned_.expect_none("distance depends on the corner that comes first");
  reversed_.expect_none("distance depends on the way round the corners");
}

INSTANTIATE_TEST_SUITE_P(Families, Kernel,
                         testing::ValuesIn(shape_families().begin(), shape_families().end()),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// The rim of a triangle's plane case: the aspect ratio grows step by step, so that the first bad one shows.
TEST(KernelAspect, error_does_not_grow_with_the_aspect_ratio) {
  Random random(12);
  for (int exponent = 0; exponent <= 15; ++exponent) {
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 u = random.direction();
      const double width = random.power_of_ten(-exponent - 0.3, -exponent);
      const Vec3 apex = plus(i % 2 == 0 ? times(random.unit(), u) : Vec3{}, width, random.direction());
      const Corners v{Vec3{}, u, apex};
      const Result<BruteForce> brute = measure_to(v);
      // A width below the rounding of the apex may leave no area at all.
      if (!brute && brute.error().code == Code::empty_mesh) continue;
      ASSERT_TRUE(brute) << brute.error().text;
      const Vec3 n = cross(u, apex);
      const Vec3 middle = times(1.0 / 3, plus(u, 1, apex));
      const double size = length(n);
      const double height = random.magnitude(-30, 3);
      const Vec3 x = size > 0 ? plus(middle, height / size, n) : plus(middle, height, random.direction());
      worst =
          std::max(worst, exact_to(x, v).error_in_ulps(brute->closest(x).distance, x, largest_coordinate(v)));
    }
    std::cout << "aspect 1e" << exponent << ": " << worst << " ulp\n";
    EXPECT_LE(worst, 4) << "aspect 1e" << exponent;
  }
}

/// Field::distance takes any finite query.
TEST(KernelRange, queries_beyond_the_supported_coordinates_are_answered_as_well) {
  Random random(13);
  Worst worst;
  for (int i = 0; i < 500; ++i) {
    const Corners v = shape_families()[static_cast<std::size_t>(i) % 3].make(random);
    const Result<BruteForce> brute = measure_to(v);
    ASSERT_TRUE(brute) << brute.error().text;
    const Vec3 d = random.direction();
    const int exponent =
        i % 2 == 0 ? 200 + static_cast<int>(random.below(820)) : -static_cast<int>(random.below(1074));
    const Vec3 x{std::ldexp(d.x, exponent), std::ldexp(d.y, exponent), std::ldexp(d.z, exponent)};
    const Closest closest = brute->closest(x);
    worst.add(errors_of(closest, x, v, exact_to(x, v), largest_coordinate(v)), [&] { return replay(x, v); });
  }
  std::cout << "beyond range: " << worst.text() << '\n';
  worst.expect_within_bounds();
}

TEST(KernelRange, queries_that_are_not_finite_give_nan) {
  const Result<BruteForce> brute = measure_to({Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}});
  ASSERT_TRUE(brute);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(brute->closest({bad, 0, 0}).distance));
    EXPECT_TRUE(std::isnan(brute->closest({0, bad, 0}).distance));
    EXPECT_TRUE(std::isnan(brute->closest({0, 0, bad}).distance));
  }
}

/// A face without area keeps its place among the neighbours and never wins: its border is theirs.
TEST(KernelNoArea, never_wins_against_the_triangle_beside_it) {
  Random random(14);
  Violations won;
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const auto even = [&] { return 2.0 * static_cast<double>(random.below(200)) - 200; };
    const std::array<Vec3, 2> ends{Vec3{even(), even(), even()}, Vec3{even(), even(), even()}};
    const Vec3 middle = times(0.5, plus(ends[0], 1, ends[1]));
    const std::vector<Vec3> vertices{ends[0], ends[1], middle, Vec3{even(), even(), even() + 0.5}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {0, 3, 2}, {2, 3, 1}};
    const Corners first{vertices[0], vertices[3], vertices[2]};
    const Corners second{vertices[2], vertices[3], vertices[1]};
    const Result<BruteForce> brute =
        BruteForce::over({Points(std::span<const Vec3>(vertices)), triangles}, Sign::none);
    ASSERT_TRUE(brute) << brute.error().text;
    const Vec3 x = i % 3 == 0 ? middle : plus(middle, random.between(0, 200), random.direction());
    const Closest closest = brute->closest(x);
    const Exact one = exact_to(x, first);
    const Exact two = exact_to(x, second);
    won.add(closest.triangle == 0, x, first);
    worst = std::max(worst, (exact_less(one, two) ? one : two).error_in_ulps(closest.distance, x, 200));
  }
  won.expect_none("a face without area won");
  EXPECT_LE(worst, 4);
}

/// Two faces give their common edge's distance in the same bits, whichever way each runs along it.
TEST(KernelEdge, both_faces_of_an_edge_agree_bit_for_bit) {
  Random random(15);
  Violations differ;
  int shared = 0;
  for (int i = 0; i < 3000; ++i) {
    const Corners v = shape_families()[static_cast<std::size_t>(i) % 3].make(random);
    const Corners other{v[1], v[0], plus(v[0], 1, random.direction())};
    const Vec3 start = plus(v[0], random.unit(), minus(v[1], v[0]));
    const Vec3 x = plus(start, random.magnitude(-40, 2), random.direction());
    const Exact one = exact_to(x, v);
    const Exact two = exact_to(x, other);
    if (compare(one.squared, two.squared) != 0) continue;
    const Result<BruteForce> left = measure_to(v);
    const Result<BruteForce> right = measure_to(other);
    ASSERT_TRUE(left && right);
    ++shared;
    differ.add(bits(left->closest(x).distance) != bits(right->closest(x).distance), x, v);
  }
  differ.expect_none("two faces of an edge differ");
  EXPECT_GT(shared, 300);
}

}  // namespace
}  // namespace cdfr::oracle
