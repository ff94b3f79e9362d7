#include <gtest/gtest.h>

#include "mesh/samples.h"

namespace cdfr {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Result<Mesh> read(const std::string& text) { return samples::read(text, ".obj"); }

TEST(Obj, PolygonsAreFansInFileOrder) {
  const auto mesh = read(square + "v 0 2 0\nf 1 2 3 4 5\nf 3 2 1\n");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {2, 1, 0}}));
  EXPECT_TRUE(mesh->patches.empty());
}

TEST(Obj, CornersOfAllForms) {
  const auto mesh =
      read(square + "f 1/7 2/8 3/9\nf 1//5 2//5 3//5\nf 1/2/3 2/2/3 4/2/3\nf -4 -3 -2\nf 1// 2/ 3//\n");
  ASSERT_TRUE(mesh) << mesh.error().text;
  EXPECT_EQ(mesh->triangles.size(), 5U);
  EXPECT_EQ(mesh->triangles[3], (Triangle{0, 1, 2}));
}

TEST(Obj, NegativeIndicesCountFromTheFace) {
  const auto mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 5\nf -4 -3 -1\n");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->triangles[1], (Triangle{0, 1, 3}));
}

TEST(Obj, PositiveIndicesMayPointForward) {
  const auto mesh = read("f 1 2 3\n" + square);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->triangles[0], (Triangle{0, 1, 2}));
}

TEST(Obj, IndicesOutOfRangeNameTheLine) {
  for (const char* face :
       {"f 1 2 0", "f 1 2 5", "f 1 2 -5", "f 1 2 4294967297", "f 1 2 -9223372036854775808"}) {
    const auto mesh = read(square + "\n" + face + "\nf 1 2 3\n");
    ASSERT_FALSE(mesh) << face;
    EXPECT_EQ(mesh.error().code, Code::bad_index) << face;
    EXPECT_EQ(mesh.error().where, 6U) << face;
  }
}

TEST(Obj, DamagedLinesNameTheLine) {
  for (const char* line :
       {"v 1 2", "v 1,5 0 0", "v a 0 0", "f 1 2 x", "f 1 2 3/x", "f 1/2/3/4 2 3", "f 1 2 3.0", "f",
        "f 1 2 /3", "surf 0 1 0 1 1 2 3", "curv 0 1 1 2", "junk", "f 1 2 99999999999999999999"}) {
    const auto mesh = read(square + line + "\n");
    ASSERT_FALSE(mesh) << line;
    EXPECT_EQ(mesh.error().code, Code::file_format) << line;
    EXPECT_EQ(mesh.error().where, 5U) << line;
  }
  EXPECT_EQ(read("v nan 0 0\n").error().code, Code::not_finite);
  EXPECT_EQ(read("v 1e999 0 0\n").error().code, Code::out_of_range);
}

TEST(Obj, FacesOfOneOrTwoCornersMakeNoTriangle) {
  const auto mesh = read(square + "f 1\nf 1 2\nf 1 2 3\n");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->triangles.size(), 1U);
}

TEST(Obj, LinesMayEndWithCrlfAndGoOnAfterABackslash) {
  const auto mesh = read("v 0 0 0 # first\r\nv 1 0 0 0.5 0.5 0.5\r\nv 0 1 \\\r\n 0\r\n\r\nf 1 2 \\\r\n3\r\n");
  ASSERT_TRUE(mesh) << mesh.error().text;
  EXPECT_EQ(mesh->triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(mesh->vertices.size(), 3U);
}

TEST(Obj, GroupsArePatchesBeforeObjectsBeforeMaterials) {
  const std::string face = "f 1 2 3\n";
  const auto groups = read(square + "o body\nusemtl steel\n" + face + "g left  side\n" + face + "g\n" + face +
                           "g left  side\n" + face);
  ASSERT_TRUE(groups);
  EXPECT_EQ(groups->patches, (std::vector<std::uint32_t>{0, 1, 0, 1}));
  EXPECT_EQ(groups->patch_names, (std::vector<std::string>{"", "left  side"}));
  const auto objects = read(square + "usemtl steel\no a\n" + face + "o empty\no b\n" + face);
  ASSERT_TRUE(objects);
  EXPECT_EQ(objects->patches, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(objects->patch_names, (std::vector<std::string>{"a", "b"}));
  const auto materials = read(square + "mtllib ../../etc/passwd\nusemtl steel\n" + face + "usemtl\n" + face);
  ASSERT_TRUE(materials);
  EXPECT_EQ(materials->patch_names, (std::vector<std::string>{"steel", ""}));
}

}  // namespace
}  // namespace cdfr
