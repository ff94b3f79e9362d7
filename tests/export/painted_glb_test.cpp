/// Painted meshes as GLB, as an independent reader sees them.
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "cdfr/export/painted.h"
#include "export/linear_light.h"
#include "export/painted_case.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

constexpr double nan = PaintedCase::nan;

class PaintedGlbTest : public ScratchTest {
 protected:
  void write(const PaintedMesh& painted, double metres_per_unit = 1) {
    const auto result = write_painted(painted, folder() / "a.glb", metres_per_unit);
    ASSERT_TRUE(result) << result.error().text;
    std::string error, warning;
    model_ = {};
    ASSERT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model_, &error, &warning, folder() / "a.glb"));
    EXPECT_EQ(error + warning, "");
  }

  const tinygltf::Node* node(const std::string& name) const {
    const auto found = std::find_if(model_.nodes.begin(), model_.nodes.end(),
                                    [&](const tinygltf::Node& one) { return one.name == name; });
    return found == model_.nodes.end() ? nullptr : &*found;
  }
  const tinygltf::Primitive& primitive(const std::string& name, std::size_t i = 0) const {
    return model_.meshes.at(static_cast<std::size_t>(node(name)->mesh)).primitives.at(i);
  }
  const tinygltf::Material& material(const tinygltf::Primitive& of) const {
    return model_.materials.at(static_cast<std::size_t>(of.material));
  }

  template <class Number>
  std::vector<Number> numbers(int number, std::size_t components) const {
    const auto& accessor = model_.accessors.at(static_cast<std::size_t>(number));
    const auto& view = model_.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
    const auto& data = model_.buffers.at(0).data;
    const std::size_t packed = components * sizeof(Number);
    const std::size_t stride = view.byteStride == 0 ? packed : view.byteStride;
    EXPECT_LE(accessor.byteOffset + (accessor.count - 1) * stride + packed, view.byteLength);
    EXPECT_LE(view.byteOffset + view.byteLength, data.size());
    std::vector<Number> values(accessor.count * components);
    for (std::size_t i = 0; i < accessor.count; ++i) {
      std::memcpy(&values[i * components], data.data() + view.byteOffset + accessor.byteOffset + i * stride,
                  packed);
    }
    return values;
  }
  std::vector<float> floats(const tinygltf::Primitive& of, const std::string& name,
                            std::size_t components = 3) const {
    return numbers<float>(of.attributes.at(name), components);
  }

  /// A point of the part, taken back through the root node.
  Vec3 in_metres(const std::vector<float>& positions, std::size_t i) const {
    const auto& root = *node("cdfr");
    const auto at = [&](std::size_t k) {
      return root.translation[k] + root.scale[k] * static_cast<double>(positions[3 * i + k]);
    };
    return {at(0), at(1), at(2)};
  }
  void expect_near(Vec3 a, Vec3 b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
  }

  tinygltf::Model model_;
};

TEST_F(PaintedGlbTest, VerticesCarryPlaceColourAndValue) {
  const PaintedCase made;
  write(made.painted(), 0.001);
  const auto& part = primitive("part");
  EXPECT_EQ(part.mode, TINYGLTF_MODE_TRIANGLES);
  const auto positions = floats(part, "POSITION"), colours = floats(part, "COLOR_0"),
             values = floats(part, "_VALUE", 1);
  ASSERT_EQ(positions.size(), 12U);
  const auto light = linear_light();
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 v = made.mesh.vertices[i];
    expect_near(in_metres(positions, i), {v.x * 0.001, v.y * 0.001, v.z * 0.001}, 1e-9);
    const Colour colour = painted_colour(made.thickness[i], 1, 11);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(colours[3 * i + k], light[colour[k]]);
    EXPECT_EQ(values[i], std::isnan(made.thickness[i]) ? std::numeric_limits<float>::lowest()
                                                       : static_cast<float>(made.thickness[i]));
  }
  EXPECT_EQ(numbers<std::uint32_t>(part.indices, 1),
            (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
  EXPECT_EQ(material(part).alphaMode, "OPAQUE");
}

TEST_F(PaintedGlbTest, TrianglesWithNumbersHaveCornersOfTheirOwn) {
  PaintedCase made;
  made.painted_array = "depth_of_face";
  write(made.painted());
  const auto& part = primitive("part");
  EXPECT_LT(part.indices, 0);
  const auto positions = floats(part, "POSITION"), values = floats(part, "_VALUE", 1);
  ASSERT_EQ(values.size(), 12U);
  for (std::size_t i = 0; i < 12; ++i)
    expect_near(in_metres(positions, i), made.mesh.vertices[made.mesh.triangles[i / 3][i % 3]], 1e-6);
  EXPECT_EQ(values[0], 0.1F);
  EXPECT_EQ(values[8], std::numeric_limits<float>::lowest());
  EXPECT_EQ(values[11], std::numeric_limits<float>::max()) << "1e300";
}

/// The format's validators want the bounds of positions to the last bit, and no number that is not finite.
TEST_F(PaintedGlbTest, AccessorsKeepTheRules) {
  write(PaintedCase().painted());
  for (std::size_t n = 0; n < model_.accessors.size(); ++n) {
    const auto& accessor = model_.accessors[n];
    if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) continue;
    const std::size_t components = accessor.type == TINYGLTF_TYPE_VEC3 ? 3 : 1;
    const auto values = numbers<float>(static_cast<int>(n), components);
    for (const float value : values) EXPECT_TRUE(std::isfinite(value));
    for (std::size_t k = 0; k < accessor.minValues.size(); ++k) {
      float lo = values[k], hi = lo;
      for (std::size_t i = k; i < values.size(); i += components) {
        lo = std::min(lo, values[i]);
        hi = std::max(hi, values[i]);
      }
      EXPECT_EQ(accessor.minValues[k], double(lo));
      EXPECT_EQ(accessor.maxValues[k], double(hi));
    }
  }
  for (const auto& view : model_.bufferViews) EXPECT_EQ(view.byteOffset % 4, 0U);
}

TEST_F(PaintedGlbTest, BallsAreHalfTransparentAndInPlace) {
  const PaintedCase made;
  PaintedMesh painted = made.painted();
  painted.translucent = true;
  write(painted);
  EXPECT_EQ(material(primitive("part")).alphaMode, "BLEND");
  const auto& root = *node("cdfr");
  for (std::size_t i = 0; i < painted.balls.size(); ++i) {
    const auto* ball = node("ball " + std::to_string(i + 1));
    ASSERT_NE(ball, nullptr);
    const auto& [centre, radius] = painted.balls[i];
    const auto at = [&](std::size_t k) { return root.translation[k] + root.scale[k] * ball->translation[k]; };
    expect_near({at(0), at(1), at(2)}, centre, 1e-14);
    EXPECT_NEAR(root.scale[0] * ball->scale[0], radius, 1e-16);
    EXPECT_EQ(ball->extras.Get("radius").GetNumberAsDouble(), radius);
    EXPECT_EQ(ball->extras.Get("center").Get(1).GetNumberAsDouble(), centre.y);
    EXPECT_EQ(ball->mesh, node("ball 1")->mesh) << "one mesh serves all";
  }
  const auto& ball_material = material(primitive("ball 1"));
  EXPECT_EQ(ball_material.alphaMode, "BLEND");
  EXPECT_EQ(ball_material.pbrMetallicRoughness.baseColorFactor.at(3), 0.6);
}

TEST_F(PaintedGlbTest, LabelsStandBesideThePartWithALineToTheirPlace) {
  const PaintedCase made;
  const PaintedMesh painted = made.painted();
  write(painted);
  const auto part = floats(primitive("part"), "POSITION");
  float left = part[0];
  for (std::size_t i = 0; i < part.size(); i += 3) left = std::min(left, part[i]);
  for (const std::string name : {"1: 17.0 mm +- 0.1", "two lines \xc2\xb1 & <b>"}) {
    ASSERT_NE(node(name), nullptr);
    const auto& line = primitive(name, 0);
    const auto& text = primitive(name, 1);
    EXPECT_EQ(line.mode, TINYGLTF_MODE_LINE);
    const Vec3 place = painted.labels[name[0] == '1' ? 0 : 1].place;
    expect_near(in_metres(floats(line, "POSITION"), 1), place, 1e-6);
    EXPECT_EQ(node(name)->extras.Get("place").Get(0).GetNumberAsDouble(), place.x);
    EXPECT_EQ(text.mode, TINYGLTF_MODE_TRIANGLES);
    const auto strokes = floats(text, "POSITION");
    for (std::size_t i = 0; i < strokes.size(); i += 3) EXPECT_LT(strokes[i], left);
    EXPECT_EQ(material(text).extensions.count("KHR_materials_unlit"), 1U);
  }
}

TEST_F(PaintedGlbTest, LegendShowsTheRampOnTheRight) {
  const PaintedCase made;
  write(made.painted());
  const auto part = floats(primitive("part"), "POSITION");
  float right = part[0];
  for (std::size_t i = 0; i < part.size(); i += 3) right = std::max(right, part[i]);
  ASSERT_NE(node("legend"), nullptr);
  const auto& bar = primitive("legend", 0);
  const auto positions = floats(bar, "POSITION"), colours = floats(bar, "COLOR_0");
  const auto light = linear_light();
  const Colour thin = painted_colour(1, 1, 11), none = painted_colour(nan, 0, 1);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(colours[k], light[thin[k]]) << "least below";
    EXPECT_EQ(colours[colours.size() - 3 + k], light[none[k]]) << "and the grey of what has no value";
  }
  for (const auto& corners : {positions, floats(primitive("legend", 1), "POSITION")}) {
    for (std::size_t i = 0; i < corners.size(); i += 3) EXPECT_GT(corners[i], right);
  }
  EXPECT_EQ(model_.asset.extras.Get("painted").Get<std::string>(), "thickness");
  EXPECT_EQ(model_.asset.extras.Get("range").Get(1).GetNumberAsInt(), 11);
  EXPECT_EQ(model_.asset.extras.Get("notes").Get(0).Get<std::string>(), "sha256: 00ff");
}

TEST_F(PaintedGlbTest, AnySizeAndPlaceFitsFloats) {
  for (const double size : {0x1p-200, 1e-30, 1e30, 0x1p200}) {
    for (const double far : {0.0, 1e3}) {
      SCOPED_TRACE(size);
      PaintedCase made;
      for (Vec3& v : made.mesh.vertices) v = {(v.x + far) * size, v.y * size, v.z * size};
      PaintedMesh painted = made.painted();
      painted.balls.clear();
      painted.labels.clear();
      write(painted);
      const auto positions = floats(primitive("part"), "POSITION");
      for (std::size_t i = 0; i < 4; ++i)
        expect_near(in_metres(positions, i), made.mesh.vertices[i], size * 1e-6);
    }
  }
  PaintedCase huge;
  huge.mesh.vertices[0].x = 1.7e308;
  huge.mesh.vertices[1].x = -1.7e308;
  EXPECT_TRUE(write_painted(huge.painted(), folder() / "huge.glb", 1));
  const auto refused = write_painted(huge.painted(), folder() / "b.glb", 10);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::out_of_range);
}

TEST_F(PaintedGlbTest, PartsWithoutThisOrThatAreFilesToo) {
  const PaintedCase made;
  write(PaintedMesh{made.mesh.view()});
  EXPECT_EQ(primitive("part").attributes.size(), 1U);
  EXPECT_EQ(node("legend"), nullptr);
  write({});
  EXPECT_TRUE(model_.nodes.empty());
  EXPECT_EQ(model_.scenes.size(), 1U);
  PaintedMesh only_balls;
  only_balls.balls = {{{1, 2, 3}, 0.5}};
  write(only_balls);
  EXPECT_EQ(node("part"), nullptr);
  EXPECT_NE(node("ball 1"), nullptr);
  PaintedMesh only_label;
  only_label.labels = {{{1, 2, 3}, ""}};
  write(only_label);
  EXPECT_NE(node(""), nullptr);
}

}  // namespace
}  // namespace cdfr
