#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "cdfr/export/write.h"
#include "export/ply_parse.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

class WriteMeshTest : public ScratchTest {
 protected:
  std::string written(const Mesh& mesh, const std::string& name) {
    const auto result = write_mesh(mesh.view(), folder() / name);
    EXPECT_TRUE(result) << result.error().text;
    return text_of(folder() / name);
  }
};

Mesh tetrahedron() {
  return {{{0.1, 0, 0}, {1, -0.0, 1e-17}, {0, 1 / 3.0, 0}, {0, 0, 123456.789}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
          {7, 7, 0, 7},
          {}};
}

TEST_F(WriteMeshTest, BadInputIsRefusedByNameAndLeavesNoFile) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Mesh bad_index = tetrahedron(), not_finite = tetrahedron(), bad_patches = tetrahedron();
  bad_index.triangles[2][1] = 4;
  not_finite.vertices[3].y = nan;
  bad_patches.patches.pop_back();
  for (const char* name : {"a.stl", "a.ply", "a.obj"}) {
    const auto path = folder() / name;
    const auto index_result = write_mesh(bad_index.view(), path);
    ASSERT_FALSE(index_result);
    EXPECT_EQ(index_result.error().code, Code::bad_index);
    EXPECT_EQ(index_result.error().where, 2U);
    const auto finite_result = write_mesh(not_finite.view(), path);
    ASSERT_FALSE(finite_result);
    EXPECT_EQ(finite_result.error().code, Code::not_finite);
    EXPECT_EQ(finite_result.error().where, 3U);
    const auto patch_result = write_mesh(bad_patches.view(), path);
    ASSERT_FALSE(patch_result);
    EXPECT_EQ(patch_result.error().code, Code::bad_option);
  }
  for (const char* name : {"a", "a.glb", "stl", ".ply", "a.ply.gz"}) {
    const auto result = write_mesh(tetrahedron().view(), folder() / name);
    ASSERT_FALSE(result) << name;
    EXPECT_EQ(result.error().code, Code::bad_option) << name;
  }
  EXPECT_TRUE(names().empty());
  const auto no_folder = write_mesh(tetrahedron().view(), folder() / "none" / "a.stl");
  ASSERT_FALSE(no_folder);
  EXPECT_EQ(no_folder.error().code, Code::file_write);
}

TEST_F(WriteMeshTest, CoordinateBeyondFloatIsRefusedInStlOnly) {
  Mesh far = tetrahedron();
  far.vertices[1].x = 1e39;
  const auto result = write_mesh(far.view(), folder() / "far.stl");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Code::out_of_range);
  EXPECT_EQ(result.error().where, 1U);
  EXPECT_TRUE(names().empty());
  EXPECT_EQ(PlyParse(written(far, "far.ply")).elements[0].rows[1][0], 1e39);
}

TEST_F(WriteMeshTest, EmptyMeshIsAFile) {
  const std::string stl = written({}, "a.STL");
  EXPECT_EQ(stl.size(), 84U);
  EXPECT_EQ(PlyParse(written({}, "a.ply")).elements.size(), 2U);
  EXPECT_EQ(written({}, "a.obj"), "# written by cdfr\n");
}

TEST_F(WriteMeshTest, StlHasUnitNormalsAndRoundedVertices) {
  Mesh mesh = tetrahedron();
  mesh.triangles.push_back({0, 0, 1});
  mesh.patches.push_back(0);
  mesh.vertices.insert(mesh.vertices.end(), {{0, 0, 0}, {1e-30, 0, 0}, {0, 1e-30, 0}});
  mesh.triangles.push_back({4, 5, 6});
  mesh.patches.push_back(0);
  const std::string bytes = written(mesh, "a.stl");
  ASSERT_EQ(bytes.size(), 84 + 50 * mesh.triangles.size());
  EXPECT_NE(bytes.substr(0, 5), "solid");
  EXPECT_EQ(little_endian_at<std::uint32_t>(bytes, 80), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t start = 84 + 50 * i;
    float length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = little_endian_at<float>(bytes, start + 4 * k);
      length += n * n;
      const Vec3 v = mesh.vertices[mesh.triangles[i][k]];
      EXPECT_EQ(little_endian_at<float>(bytes, start + 12 + 12 * k), static_cast<float>(v.x));
      EXPECT_EQ(little_endian_at<float>(bytes, start + 16 + 12 * k), static_cast<float>(v.y));
      EXPECT_EQ(little_endian_at<float>(bytes, start + 20 + 12 * k), static_cast<float>(v.z));
    }
    EXPECT_NEAR(length, i == 4 ? 0 : 1, 1e-6) << i;
    EXPECT_EQ(little_endian_at<std::uint16_t>(bytes, start + 48), 0);
  }
  EXPECT_EQ(little_endian_at<float>(bytes, 84 + 50 * 5 + 8), 1) << "the normal follows the right hand";
}

TEST_F(WriteMeshTest, PlyKeepsEveryBitAndThePatches) {
  const Mesh mesh = tetrahedron();
  const std::string bytes = written(mesh, "a.ply");
  const PlyParse ply(bytes);
  ASSERT_EQ(ply.elements.size(), 2U);
  EXPECT_EQ(ply.elements[0].properties, (std::vector<std::string>{"double x", "double y", "double z"}));
  EXPECT_EQ(ply.elements[1].properties,
            (std::vector<std::string>{"list uchar uint vertex_indices", "uint patch"}));
  ASSERT_EQ(ply.elements[0].rows.size(), mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 v = mesh.vertices[i];
    EXPECT_EQ(ply.elements[0].rows[i], (std::vector<double>{v.x, v.y, v.z}));
  }
  EXPECT_TRUE(std::signbit(ply.elements[0].rows[1][1]));
  ASSERT_EQ(ply.elements[1].rows.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    EXPECT_EQ(ply.elements[1].rows[i],
              (std::vector<double>{double(a), double(b), double(c), double(mesh.patches[i])}));
  }
  Mesh plain = mesh;
  plain.patches.clear();
  const std::string plain_bytes = written(plain, "b.ply");
  EXPECT_EQ(PlyParse(plain_bytes).elements[1].properties.size(), 1U);
}

TEST_F(WriteMeshTest, ObjGivesTheSameDoublesAndTrianglesInOrder) {
  const Mesh mesh = tetrahedron();
  std::istringstream lines(written(mesh, "a.obj"));
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::string> groups;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind, x, y, z;
    words >> kind >> x >> y >> z;
    if (kind == "v") vertices.push_back({std::stod(x), std::stod(y), std::stod(z)});
    if (kind == "g") groups.push_back(std::to_string(triangles.size()) + " " + x);
    const auto corner = [](const std::string& word) {
      return static_cast<std::uint32_t>(std::stoul(word) - 1);
    };
    if (kind == "f") triangles.push_back({corner(x), corner(y), corner(z)});
  }
  EXPECT_EQ(vertices, mesh.vertices);
  EXPECT_EQ(triangles, mesh.triangles);
  EXPECT_EQ(groups, (std::vector<std::string>{"0 patch_7", "2 patch_0", "3 patch_7"}));
}

TEST_F(WriteMeshTest, LocaleChangesNothing) {
  const std::string before = written(tetrahedron(), "a.obj");
  const char* found = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"}) {
    if (found == nullptr) found = std::setlocale(LC_ALL, name);
  }
  if (found == nullptr) GTEST_SKIP() << "no locale with a decimal comma is installed";
  const std::string after = written(tetrahedron(), "b.obj");
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(before, after);
}

}  // namespace
}  // namespace cdfr
