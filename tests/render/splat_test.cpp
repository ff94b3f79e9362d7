#include "cdfr/render/splat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "support/scratch.h"
#include "render/picture.h"

namespace cdfr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Looks down the z axis, x to the right and y up: a unit is 46 pixels, for the cube fills 92 of 100 rows.
const SplatOptions from_above{200, 100, {0, 0, -1}, {0, 1, 0}};
constexpr double pixels_a_unit = 46;

Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Points all over a sphere on a spiral that joins golden-angle turns by a rotation, so without sine and
/// cosine.
std::vector<ContourPoint> sphere(int count, double radius) {
  std::vector<ContourPoint> points;
  const double c = -0.73736887807831990, s = 0.67549029426152360;
  double x = 1, y = 0;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, ring = std::sqrt(1 - z * z);
    const Vec3 n{ring * x, ring * y, z};
    points.push_back({{radius * n.x, radius * n.y, radius * n.z}, n, 0, 0});
    const double turned = c * x - s * y;
    y = s * x + c * y;
    x = turned;
  }
  return points;
}

class SplatTest : public ScratchTest {
 protected:
  Picture drawn(std::span<const ContourPoint> points, const Mesh& part,
                const SplatOptions& options = from_above) {
    const auto result = splat_png(points, part.view(), folder() / "a.png", options);
    EXPECT_TRUE(result) << result.error().text;
    return Picture(folder() / "a.png");
  }
  Code refusal(std::span<const ContourPoint> points, const Mesh& part,
               const SplatOptions& options = from_above) {
    const auto result = splat_png(points, part.view(), folder() / "refused.png", options);
    EXPECT_FALSE(result);
    EXPECT_FALSE(std::filesystem::exists(folder() / "refused.png"));
    return result ? Code{} : result.error().code;
  }
};

TEST_F(SplatTest, BadOptionsAreRefused) {
  for (const int side : {-1, 0, 15, 16385, std::numeric_limits<int>::max()}) {
    EXPECT_EQ(refusal({}, cube(), {side, 100}), Code::bad_option);
    EXPECT_EQ(refusal({}, cube(), {100, side}), Code::bad_option);
  }
  for (const Vec3 bad : {Vec3{0, 0, 0}, Vec3{nan, 0, 1}, Vec3{infinity, 0, 1}}) {
    EXPECT_EQ(refusal({}, cube(), {100, 100, bad, {0, 1, 0}}), Code::bad_option);
    EXPECT_EQ(refusal({}, cube(), {100, 100, {0, 1, 0}, bad}), Code::bad_option);
  }
  for (const double scale : {1.0, -2.0, 1e-300, 1e300}) {
    EXPECT_EQ(refusal({}, cube(), {100, 100, {1, 2, 3}, {scale, 2 * scale, 3 * scale}}), Code::bad_option);
  }
}

TEST_F(SplatTest, BadGeometryIsRefusedByName) {
  Mesh bad_index = cube(), not_finite = cube(), beyond = cube(), unused = cube();
  bad_index.triangles[5][2] = 8;
  not_finite.vertices[3].z = nan;
  beyond.vertices[3].z = 1e300;
  unused.vertices.push_back({nan, nan, nan});
  EXPECT_EQ(refusal({}, bad_index), Code::bad_index);
  EXPECT_EQ(refusal({}, not_finite), Code::not_finite);
  EXPECT_EQ(refusal({}, beyond), Code::out_of_range);
  std::vector<ContourPoint> points = sphere(20, 1);
  points[7].position.x = infinity;
  EXPECT_EQ(refusal(points, cube()), Code::not_finite);
  drawn({}, unused);
}

TEST_F(SplatTest, UnwritablePathIsNamed) {
  const auto result = splat_png({}, cube().view(), folder() / "none" / "a.png", from_above);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Code::file_write);
  const auto folder_result = splat_png({}, cube().view(), folder(), from_above);
  ASSERT_FALSE(folder_result);
  EXPECT_EQ(folder_result.error().code, Code::file_write);
}

TEST_F(SplatTest, NothingIsWhite) {
  const Picture picture = drawn({}, {});
  EXPECT_EQ(picture.width, 200);
  EXPECT_EQ(picture.height, 100);
  EXPECT_TRUE(std::all_of(picture.rgb.begin(), picture.rgb.end(), [](int value) { return value == 255; }));
}

TEST_F(SplatTest, EmptyContourShowsThePartOnly) {
  const Picture picture = drawn({}, cube());
  EXPECT_EQ(picture.count_warm(), 0);
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      const double x = std::abs(column + 0.5 - 100), y = std::abs(row + 0.5 - 50);
      const bool inside = x < pixels_a_unit && y < pixels_a_unit;
      EXPECT_EQ(picture.white(column, row), !inside) << column << " " << row;
    }
  }
  EXPECT_GT(picture.at(100, 50)[0], 190) << "the part is pale";
}

TEST_F(SplatTest, PointLandsAtItsPixel) {
  for (const Vec3 p : {Vec3{0.5, 0.25, 0}, Vec3{-0.7, 0.6, 0.9}, Vec3{0, -0.8, -0.9}}) {
    const ContourPoint point{p, {0, 0, 1}, 0, 0};
    const Picture picture = drawn({&point, 1}, cube());
    double sum_x = 0, sum_y = 0;
    const int count = picture.count_warm();
    ASSERT_GT(count, 0);
    for (int row = 0; row < picture.height; ++row) {
      for (int column = 0; column < picture.width; ++column) {
        if (!picture.warm(column, row)) continue;
        sum_x += column + 0.5;
        sum_y += row + 0.5;
      }
    }
    EXPECT_NEAR(sum_x / count, 100 + p.x * pixels_a_unit, 0.5);
    EXPECT_NEAR(sum_y / count, 50 - p.y * pixels_a_unit, 0.5);
    EXPECT_LT(count, 60);
  }
}

TEST_F(SplatTest, NearerHidesFartherInAnyOrder) {
  const ContourPoint near{{0.2, 0.2, 0.5}, {0, 0, 1}, 0, 0}, far{{0.2, 0.2, -0.5}, {1, 0, 0.2}, 0, 0};
  const std::vector<ContourPoint> near_first = {near, far}, far_first = {far, near};
  const Picture alone = drawn({&near, 1}, cube());
  EXPECT_EQ(drawn(near_first, cube()).rgb, alone.rgb);
  EXPECT_EQ(drawn(far_first, cube()).rgb, alone.rgb);
  EXPECT_NE(drawn({&far, 1}, cube()).rgb, alone.rgb);
}

TEST_F(SplatTest, PartVeilsWhatIsInsideAndNotWhatIsInFront) {
  Mesh frame = cube();
  ContourPoint point{{0, 0, 0}, {0, 0, 1}, 0, 0};
  const auto inside = drawn({&point, 1}, frame).at(100, 50);
  point.position.z = 1.5;
  const auto in_front = drawn({&point, 1}, frame).at(100, 50);
  EXPECT_GT(inside[2], in_front[2]) << "the veil is pale";
  EXPECT_GT(inside[0], inside[2] + 60) << "and lets the colour through";
}

TEST_F(SplatTest, SurfaceLooksClosedAtAnyDensity) {
  for (const int count : {500, 5000, 100000}) {
    const SplatOptions options{300, 200, {-1, -1.4, -0.9}, {0, 0, 1}};
    const Picture picture = drawn(sphere(count, 1), {}, options);
    // Without a part the box of the points is fitted; its height in the picture is what the sphere's is not.
    const double length = std::sqrt(1 + 1.4 * 1.4 + 0.9 * 0.9), level = std::sqrt(1 + 1.4 * 1.4);
    const double reach_y = (1 * 0.9 / level + 1.4 * 0.9 / level + level) / length;
    const double radius = 100 * 0.92 / reach_y;
    for (int row = 0; row < picture.height; ++row) {
      for (int column = 0; column < picture.width; ++column) {
        const double dx = column + 0.5 - 150, dy = row + 0.5 - 100,
                     from_centre = std::sqrt(dx * dx + dy * dy);
        // The rim of a coarse cloud is ragged.
        if (from_centre < 0.95 * radius - 1) {
          ASSERT_TRUE(picture.warm(column, row)) << count << ": " << column << " " << row;
        } else if (from_centre > radius + 6) {
          ASSERT_TRUE(picture.white(column, row)) << count << ": " << column << " " << row;
        }
      }
    }
  }
}

TEST_F(SplatTest, SameBytesTwice) {
  const auto points = sphere(3000, 0.6);
  const SplatOptions wide{300, 200}, tall{16, 16384};
  for (const SplatOptions& options : {from_above, wide, tall}) {
    drawn(points, cube(), options);
    const std::string first = text_of(folder() / "a.png");
    drawn(points, cube(), options);
    EXPECT_TRUE(first == text_of(folder() / "a.png"));
  }
  EXPECT_EQ(names(), std::vector<std::string>{"a.png"});
}

/// A sheet across the whole picture has one colour: at a seam between bands it would change.
TEST_F(SplatTest, BandsJoinWithoutASeam) {
  Mesh sheet;
  sheet.vertices = {{-1, -8, 0}, {1, -8, 0}, {1, 8, 0}, {-1, 8, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Picture picture = drawn({}, sheet, {300, 2000, {0, 0, -1}, {0, 1, 0}});
  for (int row = 90; row < 1910; ++row) {
    ASSERT_EQ(picture.at(120, row), picture.at(150, 1000)) << row;
    ASSERT_EQ(picture.at(180, row), picture.at(150, 1000)) << row;
  }
}

TEST_F(SplatTest, DegenerateAndExtremeShapesAreDrawn) {
  Mesh spot, needle, edge_on, huge = cube(), tiny = cube();
  spot.vertices = {{5, 5, 5}};
  spot.triangles = {{0, 0, 0}};
  needle.vertices = {{0, 0, 0}, {1, 1e-17, 0}, {2, 0, 0}};
  needle.triangles = {{0, 1, 2}, {2, 1, 0}, {1, 1, 2}};
  edge_on.vertices = {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 1, 0}};
  edge_on.triangles = {{0, 1, 2}, {0, 1, 3}};
  for (Vec3& v : huge.vertices) v = {v.x * 0x1p199, v.y * 0x1p199, v.z * 0x1p199};
  for (Vec3& v : tiny.vertices) v = {v.x * 0x1p-200, v.y * 0x1p-200, v.z * 0x1p-200};
  ContourPoint odd{{0, 0, 0}, {nan, 0, 0}, 0, 0};
  for (const Mesh& mesh : {spot, needle, edge_on}) drawn({&odd, 1}, mesh);
  EXPECT_EQ(drawn({}, huge).rgb, drawn({}, cube()).rgb);
  EXPECT_EQ(drawn({}, tiny).rgb, drawn({}, cube()).rgb);
  const std::vector<ContourPoint> same(1000, ContourPoint{{3, 3, 3}, {0, 0, 0}, 0, 0});
  EXPECT_GT(drawn(same, {}).count_warm(), 0);
}

TEST_F(SplatTest, RandomSoupNeverLeavesThePicture) {
  std::uint64_t state = 1;
  const auto random = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const double value = static_cast<double>(state >> 11) * 0x1p-52 - 1;
    return (state >> 60) == 0 ? std::round(value) * 1e9 : value;
  };
  for (int round = 0; round < 20; ++round) {
    Mesh soup;
    std::vector<ContourPoint> points;
    for (int i = 0; i < 60; ++i) soup.vertices.push_back({random(), random(), random()});
    for (std::uint32_t i = 0; i + 2 < 60; ++i) soup.triangles.push_back({i, i + 1, i + 2});
    for (int i = 0; i < 50; ++i)
      points.push_back({{random(), random(), random()}, {random(), random(), random()}, 0, 0});
    const Picture picture =
        drawn(points, soup, {40, 30, {random(), random(), random()}, {random(), random(), 2}});
    EXPECT_EQ(picture.width, 40);
  }
}

}  // namespace
}  // namespace cdfr
