// Estimates of a large triangle are off by a share of its size. An engine that judges it by the slack of the
// small triangles that it has seen first, loses it where both are about equally close.
#include <gtest/gtest.h>

#include <cmath>

#include "cdfr/field/field.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

/// Dust about the origin under eight large triangles, one over the other, about level.
Mesh dust_under_sheets(test::Random& random, double height, double dust) {
  Mesh mesh = test::soup(32, {{-dust, -dust, -dust}, {dust, dust, 0}}, random.bits());
  for (int i = 0; i < 8; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto z = [&] { return height * (1 + 1e-3 * i) + random.between(-1e-5, 1e-5); };
    mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, z()}, {1, -1, z()}, {0.1, 1, z()}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(SmallBesideLarge, TheCloserOneAnswersWhereBothAreAboutEquallyClose) {
  test::Random random(1);
  for (int i = 0; i < 20; ++i) {
    const double height = random.between(0.002, 0.02);
    const Mesh mesh = dust_under_sheets(random, height, 1e-6);
    BuildOptions options;
    options.sign = Sign::none;
    options.max_triangles_per_leaf = 32;
    const Field field = Field::build(mesh.view(), options).value();
    const BruteForce brute = BruteForce::over(mesh.view(), Sign::none).value();
    for (int k = 0; k < 500; ++k) {
      Vec3 p{random.between(-1e-6, 1e-6), random.between(-1e-6, 1e-6), height / 2};
      p.z += random.between(-2e-5, 2e-5);
      ASSERT_TRUE(test::same_bits(field.closest(p), brute.closest(p)));
    }
  }
}

}  // namespace
}  // namespace cdfr
