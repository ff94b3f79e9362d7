// Distance, point, triangle, barycentrics, feature and normal belong to one and the same place.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "cdfr/field/field.h"
#include "faults/plain_distance.h"
#include "faults/promise.h"
#include "faults/star.h"
#include "support/joined.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

class TornAnswer : public testing::Test {
 protected:
  void expect_whole(const Mesh& mesh, std::uint64_t seed) {
    mesh_ = mesh;
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) mesh_.patches.push_back(i / 3);
    const Field field = Field::build(mesh_.view()).value();
    test::Random random(seed);
    for (int i = 0; i < 3000; ++i) {
      p_ = random.in(test::scaled(field.bounds(), 1.5));
      if (i % 4 == 0) p_ = mesh_.vertices[random.below(mesh_.vertices.size())];
      c_ = field.closest(p_);
      ulp_ = test::allowance(field.bounds(), p_) / 4;
      ASSERT_EQ(c_.distance, field.distance(p_));
      ASSERT_NO_FATAL_FAILURE(check_triangle());
      ASSERT_NO_FATAL_FAILURE(check_feature());
      ASSERT_NO_FATAL_FAILURE(check_distance());
    }
  }

 private:
  void check_triangle() {
    ASSERT_LT(c_.triangle, mesh_.triangles.size());
    ASSERT_EQ(c_.patch, c_.triangle / 3);
    for (std::size_t k = 0; k < 3; ++k) corners_[k] = mesh_.vertices[mesh_.triangles[c_.triangle][k]];
    double sum = 0;
    Vec3 mix;
    for (std::size_t k = 0; k < 3; ++k) {
      const double w = c_.barycentric[k];
      ASSERT_GE(w, 0);
      ASSERT_LE(w, 1);
      sum += w;
      mix = {mix.x + w * corners_[k].x, mix.y + w * corners_[k].y, mix.z + w * corners_[k].z};
    }
    ASSERT_NEAR(sum, 1, 4 * 0x1p-52);
    ASSERT_LE(test::length_of({mix.x - c_.point.x, mix.y - c_.point.y, mix.z - c_.point.z}), 8 * ulp_);
    ASSERT_LE(test::plain_distance(c_.point, corners_), 2 * ulp_);
  }

  void check_feature() {
    const auto at = static_cast<std::size_t>(c_.element);
    ASSERT_LT(at, 3U);
    if (c_.feature == Feature::vertex) {
      ASSERT_EQ(c_.point, corners_[at]);
      ASSERT_EQ(c_.barycentric[at], 1);
    } else if (c_.feature == Feature::edge) {
      ASSERT_EQ(c_.barycentric[(at + 2) % 3], 0);
      ASSERT_LE(test::plain_distance(c_.point, corners_[at], corners_[(at + 1) % 3]), 2 * ulp_);
    } else {
      ASSERT_EQ(at, 0U);
    }
  }

  void check_distance() {
    const test::Offset offset = test::between(c_.point, p_);
    const auto away = static_cast<double>(std::sqrt(test::dot(offset, offset)));
    ASSERT_NEAR(std::fabs(c_.distance), away, 4 * ulp_);
    ASSERT_NEAR(test::length_of(c_.gradient), 1, 1e-15);
    if (away == 0) return;
    const double sign = c_.distance < 0 ? -1 : 1, slack = 4 * ulp_ / away + 1e-15;
    ASSERT_NEAR(c_.gradient.x, sign * static_cast<double>(offset[0]) / away, slack);
    ASSERT_NEAR(c_.gradient.y, sign * static_cast<double>(offset[1]) / away, slack);
    ASSERT_NEAR(c_.gradient.z, sign * static_cast<double>(offset[2]) / away, slack);
  }

  Mesh mesh_;
  std::array<Vec3, 3> corners_{};
  Vec3 p_;
  Closest c_;
  double ulp_ = 0;
};

TEST_F(TornAnswer, OnValidMeshes) {
  expect_whole(test::sphere_mesh(3, 1, {0.1, 0.2, 0.3}), 1);
  expect_whole(test::spiky_star(2, 2), 2);
  expect_whole(test::many_fans(104), 3);
  expect_whole(test::flat_tetrahedron(), 4);
}

TEST_F(TornAnswer, OnOpenCrossingAndDistantMeshes) {
  expect_whole(test::soup(60, {{0, 0, 0}, {1, 1, 1}}, 5), 5);
  expect_whole(test::soup(60, {{1e6, -1e6, 3}, {1e6 + 1, 1 - 1e6, 4}}, 6), 6);
  expect_whole(test::soup(60, {{0, 0, 0}, {1e-9, 1, 1e-3}}, 7), 7);
}

/// Equally close triangles: the lowest number answers, for every part of the answer.
TEST_F(TornAnswer, WhereTrianglesAreThereTwice) {
  const Mesh star = test::spiky_star(1, 8);
  const Mesh twice = test::joined(star, star);
  expect_whole(twice, 8);
  const Field field = Field::build(twice.view()).value();
  test::Random random(9);
  for (int i = 0; i < 2000; ++i) {
    ASSERT_LT(field.closest(random.in(test::scaled(field.bounds(), 1.5))).triangle, star.triangles.size());
  }
}

}  // namespace
}  // namespace cdfr
