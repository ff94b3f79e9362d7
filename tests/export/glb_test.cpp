/// GLB files as an independent reader sees them.
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "cdfr/export/write.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

class GlbTest : public ScratchTest {
 protected:
  tinygltf::Model read(const std::vector<ContourPoint>& points, double metres_per_unit) {
    auto file = create_point_file(folder() / "a.glb", metres_per_unit);
    EXPECT_TRUE(file && (*file)->write(points) && (*file)->finish());
    tinygltf::Model model;
    std::string error, warning;
    const bool good = tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &error, &warning, folder() / "a.glb");
    EXPECT_TRUE(good) << error;
    EXPECT_EQ(error + warning, "");
    return model;
  }

  static std::vector<float> row(const tinygltf::Model& model, int accessor_number, std::size_t i) {
    const auto& accessor = model.accessors.at(static_cast<std::size_t>(accessor_number));
    const auto& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
    const auto& data = model.buffers.at(static_cast<std::size_t>(view.buffer)).data;
    std::vector<float> values(3);
    const std::size_t offset = view.byteOffset + accessor.byteOffset + i * view.byteStride;
    EXPECT_LE(offset + 12, data.size());
    std::memcpy(values.data(), data.data() + offset, 12);
    return values;
  }
};

std::vector<ContourPoint> cloud(std::size_t count) {
  std::vector<ContourPoint> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i);
    points[i].position = {1e7 + t / 16, 3 - t, -0.001 * t};
    points[i].normal = {0, i % 2 == 0 ? 1.0 : -1.0, 0};
  }
  return points;
}

TEST_F(GlbTest, PointsComeBackInMetres) {
  const auto points = cloud(500);
  const double metres = 0.0254;
  const auto model = read(points, metres);
  ASSERT_EQ(model.scenes.size(), 1U);
  ASSERT_EQ(model.scenes[0].nodes, std::vector<int>{0});
  ASSERT_EQ(model.nodes.size(), 1U);
  ASSERT_EQ(model.meshes.size(), 1U);
  const auto& primitive = model.meshes[0].primitives.at(0);
  EXPECT_EQ(primitive.mode, TINYGLTF_MODE_POINTS);
  const auto& translation = model.nodes[0].translation;
  const auto& scale = model.nodes[0].scale;
  ASSERT_EQ(translation.size(), 3U);
  ASSERT_EQ(scale, std::vector<double>(3, metres));
  const int position = primitive.attributes.at("POSITION"), normal = primitive.attributes.at("NORMAL");
  ASSERT_EQ(model.accessors[static_cast<std::size_t>(position)].count, points.size());
  ASSERT_EQ(model.accessors[static_cast<std::size_t>(normal)].count, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = row(model, position, i), n = row(model, normal, i);
    const double expected[] = {points[i].position.x, points[i].position.y, points[i].position.z};
    for (std::size_t k = 0; k < 3; ++k) {
      // Relative to the translation float32 resolves 2^-24 of the cloud, which at 1e7 it could not by itself.
      EXPECT_NEAR(translation[k] + scale[k] * double(p[k]), metres * expected[k], metres * 5e-5);
    }
    EXPECT_EQ(n, (std::vector<float>{0, i % 2 == 0 ? 1.0F : -1.0F, 0}));
  }
}

TEST_F(GlbTest, AccessorBoundsAreExact) {
  const auto points = cloud(77);
  const auto model = read(points, 1);
  const auto& accessor = model.accessors.at(0);
  ASSERT_EQ(accessor.minValues.size(), 3U);
  ASSERT_EQ(accessor.maxValues.size(), 3U);
  std::vector<float> lo(3, std::numeric_limits<float>::max()), hi(3, std::numeric_limits<float>::lowest());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = row(model, 0, i);
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], p[k]);
      hi[k] = std::max(hi[k], p[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(accessor.minValues[k], double(lo[k]));
    EXPECT_EQ(accessor.maxValues[k], double(hi[k]));
  }
}

TEST_F(GlbTest, LengthsInTheHeadersAddUp) {
  read(cloud(3), 1);
  const std::string bytes = text_of(folder() / "a.glb");
  const auto number = [&](std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, 4);
    return value;
  };
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(number(4), 2U);
  EXPECT_EQ(number(8), bytes.size());
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(number(12) % 4, 0U);
  EXPECT_EQ(bytes[20], '{');
  const std::size_t binary = 20 + number(12);
  EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(number(binary), 3 * 24U);
  EXPECT_EQ(binary + 8 + number(binary), bytes.size());
}

TEST_F(GlbTest, WorstNumbersFitTheReservedText) {
  std::vector<ContourPoint> points(2);
  points[0].position = {-1.2345678901234567e-300, -1.2345678901234567e+201, -1.2345678901234567e-200};
  points[1].position = {-1.7976931e+38, points[0].position.y, -1.17549435e-38};
  const auto model = read(points, 1.2345678901234567e-100);
  EXPECT_EQ(model.accessors.at(0).count, 2U);
  EXPECT_EQ(model.nodes.at(0).translation.at(1), points[0].position.y * 1.2345678901234567e-100);
}

TEST_F(GlbTest, NoPointsGiveAnEmptyScene) {
  const auto model = read({}, 1);
  EXPECT_EQ(model.scenes.size(), 1U);
  EXPECT_TRUE(model.nodes.empty());
  EXPECT_TRUE(model.accessors.empty());
}

}  // namespace
}  // namespace cdfr
