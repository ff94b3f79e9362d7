/// Whole models: the field says what brute force says, bit for bit, and both say what exact arithmetic says.
///
/// All points (point_count.h) are compared bit for bit; the exact oracle looks at the first `oracle_points`
/// of them, which hold every kind of point.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cdfr/field/field.h"
#include "cdfr/mesh/audit.h"
#include "oracle/candidates.h"
#include "oracle/claims.h"
#include "oracle/exact_distance.h"
#include "oracle/exact_side.h"
#include "oracle/models.h"
#include "oracle/point_count.h"
#include "oracle/random.h"
#include "oracle/samples.h"

namespace cdfr::oracle {
namespace {

constexpr std::size_t oracle_points = 1000;

/// A long run takes the field as it comes. Answers do not depend on the depth, and most of a short run would
/// be spent on building leaves for a handful of points.
BuildOptions options(std::size_t triangles) {
  BuildOptions result;
  if (short_run()) result.max_level = triangles <= 20'000 ? 5 : 2;
  return result;
}

std::vector<std::uint64_t> bits(const Closest& c) {
  std::vector<std::uint64_t> result;
  for (const double x : {c.distance, c.point.x, c.point.y, c.point.z, c.gradient.x, c.gradient.y,
                         c.gradient.z, c.barycentric[0], c.barycentric[1], c.barycentric[2]}) {
    result.push_back(std::bit_cast<std::uint64_t>(x));
  }
  for (const std::uint64_t n : {std::uint64_t{c.triangle}, std::uint64_t{c.patch},
                                static_cast<std::uint64_t>(c.feature), std::uint64_t{c.element}}) {
    result.push_back(n);
  }
  return result;
}

std::string text(const Closest& c) {
  std::ostringstream out;
  out << std::hexfloat << "distance " << c.distance << " point {" << c.point.x << ", " << c.point.y << ", "
      << c.point.z << "} gradient {" << c.gradient.x << ", " << c.gradient.y << ", " << c.gradient.z
      << "} triangle " << c.triangle << " patch " << c.patch << " feature " << static_cast<int>(c.feature)
      << " element " << static_cast<int>(c.element) << " barycentric {" << c.barycentric[0] << ", "
      << c.barycentric[1] << ", " << c.barycentric[2] << '}';
  return out.str();
}

Corners corners_of(MeshView mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

double largest_of(MeshView mesh) {
  double largest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t i : t) largest = std::max(largest, largest_coordinate(mesh.vertices[i]));
  }
  return largest;
}

class ModelTest : public testing::TestWithParam<Model> {
 protected:
  void SetUp() override {
    Result<Mesh> loaded = load(GetParam());
    if (!loaded) GTEST_SKIP() << "not readable: " << loaded.error().text;
    mesh_ = std::move(*loaded);
    const Result<MeshReport> report = audit(mesh_.view());
    if (!report) GTEST_SKIP() << "refused: " << report.error().text;
    balanced_ = report->balanced();
    Result<Field> field = Field::build(mesh_.view(), options(mesh_.triangles.size()));
    ASSERT_TRUE(field) << field.error().text;
    Result<BruteForce> brute = BruteForce::over(mesh_.view());
    ASSERT_TRUE(brute) << brute.error().text;
    field_ = *field;
    brute_ = *brute;
    Random random(17);
    points_ = model_points(random, mesh_.view(), *field_, point_count(mesh_.triangles.size()));
  }

  void compare_bits() {
    std::size_t different = 0;
    for (const Vec3& x : points_) {
      const Closest expected = brute_->closest(x);
      const Closest found = field_->closest(x);
      const bool same_distance = std::bit_cast<std::uint64_t>(field_->distance(x)) ==
                                 std::bit_cast<std::uint64_t>(expected.distance);
      if (bits(expected) == bits(found) && same_distance) continue;
      if (different++ < 3) {
        ADD_FAILURE() << "field and brute force differ at " << std::hexfloat << x.x << ", " << x.y << ", "
                      << x.z << "\n field " << text(found) << "\n brute " << text(expected);
      }
    }
    EXPECT_EQ(different, 0U) << "of " << points_.size() << " points";
  }

  void compare_with_truth(std::size_t count) {
    const MeshView mesh = mesh_.view();
    const Candidates candidates(mesh);
    const double largest = largest_of(mesh);
    Worst worst;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 x = points_[i];
      const Closest closest = field_->closest(x);
      ASSERT_LT(closest.triangle, mesh.triangles.size());
      const Corners v = corners_of(mesh, closest.triangle);
      Errors errors = errors_of(closest, x, v, exact_distance(x, v[0], v[1], v[2]), largest);
      const ExactClosest truth = exact_closest(mesh, x, candidates.near(x));
      const double error = truth.exact.error_in_ulps(std::abs(closest.distance), x, largest);
      double& distance = errors[static_cast<std::size_t>(Claim::distance)];
      distance = std::max(distance, error);
      worst.add(errors, [&] { return replay(x, v); });
    }
    worst.expect_within_bounds();
    std::cout << GetParam() << ": " << mesh.triangles.size() << " triangles, " << points_.size()
              << " points, " << count << " held to the truth: " << worst.text() << '\n';
    RecordProperty("worst_ulp", std::to_string(worst[Claim::distance]));
  }

  /// Inside is where the mesh winds round the point once or more, whatever crosses, touches or is turned.
  void compare_sides(std::size_t count) {
    EXPECT_NE(field_->sign(), Sign::none);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double distance = field_->distance(points_[i]);
      const std::optional<int> winding = exact_winding(mesh_.view(), points_[i]);
      // A distance that rounds to zero has no side.
      if (!winding || distance == 0 || (distance < 0) == (*winding >= 1)) continue;
      if (wrong++ < 3) {
        const Vec3 x = points_[i];
        ADD_FAILURE() << "winding number " << *winding << " but " << text(field_->closest(x)) << " at "
                      << std::hexfloat << x.x << ", " << x.y << ", " << x.z;
      }
    }
    EXPECT_EQ(wrong, 0U) << "signs of " << count;
  }

  Mesh mesh_;
  bool balanced_ = false;
  std::optional<Field> field_;
  std::optional<BruteForce> brute_;
  std::vector<Vec3> points_;
};

TEST_P(ModelTest, field_is_brute_force_is_truth) {
  const std::size_t count = std::min(points_.size(), oracle_points);
  compare_bits();
  compare_with_truth(count);
  if (balanced_) compare_sides(count);
}

INSTANTIATE_TEST_SUITE_P(Models, ModelTest, testing::ValuesIn(models()),
                         [](const auto& instance) { return instance.param.name; });

/// The tests above pass over what cannot be read or is refused; this one sees to it that this is not most
/// of it.
TEST(ModelList, has_most_of_the_shared_models) {
  const std::vector<Model> all = models();
  const bool shared = std::ranges::any_of(all, [](const Model& model) { return model.part.empty(); });
  std::size_t closed = 0;
  for (const Model& model : all) {
    const Result<Mesh> mesh = load(model);
    if (!mesh) {
      EXPECT_TRUE(model.part.empty()) << mesh.error().text;
      continue;
    }
    const Result<MeshReport> report = audit(mesh->view());
    const bool is_closed = report && report->closed();
    EXPECT_TRUE(model.part.empty() || is_closed) << model;
    closed += is_closed;
  }
  if (!shared) GTEST_SKIP() << "no models in " << CDFR_SHARED_DATA;
  EXPECT_GE(closed, 30U);
}

}  // namespace
}  // namespace cdfr::oracle
