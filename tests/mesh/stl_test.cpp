#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/samples.h"

namespace cdfr {
namespace {

using samples::raw;
using samples::read;

TEST(StlBinary, CountMustMatchTheSize) {
  std::string more = samples::binary_stl() + "x";
  EXPECT_EQ(read(more, ".stl").error().code, Code::file_format);
  std::string fewer = samples::binary_stl();
  fewer.pop_back();
  EXPECT_EQ(read(fewer, ".stl").error().code, Code::file_truncated);
  std::string huge = samples::binary_stl();
  huge.replace(80, 4, raw(0xffffffffU));
  const auto refused = read(huge, ".stl");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::file_truncated);
  EXPECT_NE(refused.error().text.find("4294967295"), std::string::npos) << refused.error().text;
  EXPECT_NE(refused.error().text.find("684"), std::string::npos) << refused.error().text;
}

TEST(StlBinary, HeaderMayBeginWithSolid) {
  const auto mesh = read(samples::binary_stl("solid but binary"), ".stl");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->triangles.size(), 12U);
  std::string cut = samples::binary_stl("solid but binary");
  cut.resize(cut.size() - 50);
  EXPECT_EQ(read(cut, ".stl").error().code, Code::file_truncated);
}

TEST(StlBinary, NonFiniteCoordinatesNameTheTriangle) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    std::string bytes = samples::binary_stl();
    bytes.replace(84 + 50 * 7 + 12 + 4, 4, raw(bad));
    const auto mesh = read(bytes, ".stl");
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, Code::not_finite);
    EXPECT_EQ(mesh.error().where, 7U);
  }
}

TEST(StlBinary, NormalsAreNotUsed) {
  std::string bytes = samples::binary_stl();
  bytes.replace(84, 4, raw(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_TRUE(read(bytes, ".stl"));
}

TEST(Stl, NoTrianglesIsAnEmptyMesh) {
  EXPECT_TRUE(read(std::string(84, '\0'), ".stl")->triangles.empty());
  EXPECT_TRUE(read("solid nothing\nendsolid nothing", ".stl")->triangles.empty());
  EXPECT_EQ(read("", ".stl").error().code, Code::file_truncated);
}

TEST(StlAscii, SolidsArePatches) {
  const std::string facet =
      "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n";
  const auto mesh =
      read("solid  a part \r\n" + facet + "endsolid\nSOLID b\n" + facet + facet + "ENDSOLID b\n");
  ASSERT_TRUE(mesh) << mesh.error().text;
  EXPECT_EQ(mesh->patches, (std::vector<std::uint32_t>{0, 1, 1}));
  EXPECT_EQ(mesh->patch_names, (std::vector<std::string>{"a part", "b"}));
  EXPECT_EQ(mesh->vertices.size(), 9U);
  EXPECT_EQ(mesh->triangles[2], (Triangle{6, 7, 8}));
}

TEST(StlAscii, DamageNamesTheLine) {
  const auto with_vertex = [](const std::string& vertex) {
    return read("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex " + vertex +
                "\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  };
  EXPECT_TRUE(with_vertex("+1 -2.5e-3 .5"));
  const std::vector<std::pair<std::string, Code>> cases = {
      {"1,5 0 0", Code::file_format},     {"1.5.2 0 0", Code::file_format}, {"0x10 0 0", Code::file_format},
      {"nan 0 0", Code::not_finite},      {"0 -inf 0", Code::not_finite},   {"1e400 0 0", Code::out_of_range},
      {"0 0 1e-400", Code::out_of_range}, {"0 0 1e70", Code::out_of_range}, {"1e-70 0 0", Code::out_of_range},
      {"+-1 0 0", Code::file_format}};
  for (const auto& [vertex, code] : cases) {
    const auto mesh = with_vertex(vertex);
    ASSERT_FALSE(mesh) << vertex;
    EXPECT_EQ(mesh.error().code, code) << vertex;
    EXPECT_EQ(mesh.error().where, 5U) << vertex;
    EXPECT_EQ(mesh.error().text.find("line 5: "), 0U) << mesh.error().text;
  }
  EXPECT_EQ(with_vertex("1 0").error().where, 6U);
}

TEST(StlAscii, PolygonsAndStrayTextAreRefused) {
  EXPECT_FALSE(
      read("solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 "
           "endloop endfacet endsolid"));
  EXPECT_FALSE(read("solid a\nendsolid a\nstray"));
  EXPECT_EQ(read("solid a\n").error().code, Code::file_truncated);
}

}  // namespace
}  // namespace cdfr
