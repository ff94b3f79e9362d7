// What must not change when the mesh is written down in another way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cdfr/field/field.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

constexpr Box around{{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}};

Field unsigned_field(const Mesh& mesh) {
  BuildOptions options;
  options.sign = Sign::none;
  return Field::build(mesh.view(), options).value();
}

TEST(Metamorphic, PermutedTrianglesAndCornersGiveTheSameBits) {
  const Mesh mesh = test::sphere_mesh(3);
  Mesh permuted = mesh;
  test::Random random(10);
  for (std::size_t i = permuted.triangles.size(); i > 1; --i) {
    std::swap(permuted.triangles[i - 1], permuted.triangles[random.below(i)]);
    Triangle& t = permuted.triangles[i - 1];
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.below(3)), t.end());
  }
  const Field a = unsigned_field(mesh), b = unsigned_field(permuted);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = random.in(around);
    ASSERT_TRUE(test::same_bits(a.distance(p), b.distance(p)));
  }
}

TEST(Metamorphic, ScalingByAPowerOfTwoScalesTheBits) {
  const Mesh mesh = test::sphere_mesh(3);
  const Field a = unsigned_field(mesh);
  for (const int k : {-150, -20, 3, 60, 190}) {
    const double s = std::ldexp(1.0, k);
    Mesh larger = mesh;
    for (Vec3& v : larger.vertices) {
      // Coordinates too small for the supported range become 0 in both.
      v = {v.x * s, v.y * s, v.z * s};
    }
    const Result<Field> built = Field::build(larger.view(), {});
    if (!built) {
      EXPECT_EQ(built.error().code, Code::out_of_range);
      continue;
    }
    const Field b = unsigned_field(larger);
    test::Random random(11);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = random.in(around);
      ASSERT_TRUE(test::same_bits(a.distance(p) * s, b.distance({p.x * s, p.y * s, p.z * s}))) << k;
    }
  }
}

/// Splitting every triangle at an edge's midpoint moves the surface by the midpoint's rounding: half an ulp a
/// coordinate.
TEST(Metamorphic, SplitAtMidpointsStaysWithinTheDerivedBound) {
  const Mesh mesh = test::sphere_mesh(3);
  Mesh split;
  split.vertices = mesh.vertices;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 p = mesh.vertices[t[0]], q = mesh.vertices[t[1]];
    const auto m = static_cast<std::uint32_t>(split.vertices.size());
    split.vertices.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
    split.triangles.push_back({t[0], m, t[2]});
    split.triangles.push_back({m, t[1], t[2]});
  }
  const Field a = unsigned_field(mesh), b = unsigned_field(split);
  test::Random random(12);
  const double bound = 2 * 4 * 0x1p-52 + std::sqrt(3.0) * 0x1p-53;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = random.in(around);
    ASSERT_NEAR(a.distance(p), b.distance(p), bound);
  }
}

/// Rotation by the exact matrix of (3, 4, 5): each rotated coordinate rounds three times, below 2^-51 in all
/// for sizes below 2.
TEST(Metamorphic, RotatedStaysWithinTheDerivedBound) {
  const auto rotated = [](const Vec3& v) {
    return Vec3{(3 * v.x - 4 * v.y) / 5, (4 * v.x + 3 * v.y) / 5, v.z};
  };
  const Mesh mesh = test::sphere_mesh(3);
  Mesh turned = mesh;
  for (Vec3& v : turned.vertices) v = rotated(v);
  const Field a = unsigned_field(mesh), b = unsigned_field(turned);
  test::Random random(13);
  const double bound = 2 * 4 * 0x1p-51 + 2 * 2 * 0x1p-50;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = random.in(around);
    ASSERT_NEAR(a.distance(p), b.distance(rotated(p)), bound);
  }
}

TEST(Metamorphic, TheDistanceHasSlopeOne) {
  const Field field = Field::build(test::sphere_mesh(4).view()).value();
  test::Random random(14);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = random.in(around), q = random.in(around);
    const double apart = std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
    ASSERT_LE(std::fabs(field.distance(p) - field.distance(q)), apart + 10 * 0x1p-52);
  }
}

}  // namespace
}  // namespace cdfr
