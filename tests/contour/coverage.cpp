#include "contour/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "support/random.h"

namespace cdfr::test {
namespace {

double squared_between(const Vec3& a, const Vec3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + y * y + z * z;
}

/// Buckets of the tolerance's size: what is within the tolerance is in one of 27.
class Buckets {
 public:
  explicit Buckets(const Contour& contour) : size_(contour.tolerance) {
    for (const ContourPoint& p : contour.points) buckets_[bucket_of(p.position)].push_back(p.position);
  }

  /// Distance to the nearest point of the 27 buckets round x.
  double nearest(const Vec3& x) const {
    double least = std::numeric_limits<double>::infinity();
    const Bucket middle = bucket_of(x);
    for (int i = 0; i < 27; ++i) {
      const auto at =
          buckets_.find({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1});
      if (at == buckets_.end()) continue;
      for (const Vec3& p : at->second) least = std::min(least, squared_between(p, x));
    }
    return std::sqrt(least);
  }

 private:
  using Bucket = std::array<std::int64_t, 3>;
  Bucket bucket_of(const Vec3& x) const {
    const auto place = [this](double v) { return static_cast<std::int64_t>(std::floor(v / size_)); };
    return {place(x.x), place(x.y), place(x.z)};
  }
  double size_;
  std::map<Bucket, std::vector<Vec3>> buckets_;
};

}  // namespace

std::vector<Vec3> true_contour(const Case& part, double distance, const Box& box, std::size_t count,
                               std::uint64_t seed) {
  const double height = std::fabs(distance), side = distance < 0 ? -1 : 1;
  Random random(seed);
  std::vector<Vec3> found;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 x = random.in(box);
    const Closest c = part.brute.closest(x);
    const double value = side * c.distance;
    if (!(value > height)) continue;
    const double share = height / value;
    found.push_back({c.point.x + (x.x - c.point.x) * share, c.point.y + (x.y - c.point.y) * share,
                     c.point.z + (x.z - c.point.z) * share});
  }
  return found;
}

std::vector<Vec3> points_on_edges(const Box& box, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 p = random.in(box);
    const auto way = random.below(3), ends = random.below(4);
    if (way != 0) p.x = ends & 1 ? box.hi.x : box.lo.x;
    if (way != 1) p.y = ends & (way == 0 ? 1U : 2U) ? box.hi.y : box.lo.y;
    if (way != 2) p.z = ends & 2 ? box.hi.z : box.lo.z;
    points.push_back(p);
  }
  return points;
}

void expect_covered(const Contour& contour, std::span<const Vec3> true_points) {
  ASSERT_FALSE(true_points.empty());
  const Buckets buckets(contour);
  double worst = 0;
  for (const Vec3& x : true_points) worst = std::max(worst, buckets.nearest(x));
  EXPECT_LE(worst, contour.tolerance * (1 + 1e-12)) << "a hole, distance " << contour.distance;
}

void expect_contour_covers(const Case& part, const Contour& contour, std::span<const Vec3> true_points) {
  for (const Vec3& x : true_points) {
    ASSERT_NEAR(part.brute.closest(x).distance, contour.distance, 1e-13);
  }
  expect_covered(contour, true_points);
}

}  // namespace cdfr::test
