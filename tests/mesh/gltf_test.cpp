#include <gtest/gtest.h>

#include "cdfr/mesh/audit.h"
#include "mesh/samples.h"

namespace cdfr {
namespace {

using samples::glb;
using samples::gltf_json;
using samples::raw;
using samples::read;

/// The sample's JSON with one piece replaced.
std::string edited(const std::string& from, const std::string& to) {
  std::string json = gltf_json();
  const auto at = json.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) json.replace(at, from.size(), to);
  return json;
}

void expect_refused(const std::string& bytes, Code code, const std::string& why) {
  const auto mesh = read(bytes);
  ASSERT_FALSE(mesh) << why;
  EXPECT_EQ(mesh.error().code, code) << why << ": " << mesh.error().text;
  EXPECT_EQ(mesh.error().text.find('\n'), std::string::npos);
}

TEST(Gltf, NothingOutsideTheFileIsOpened) {
  for (const char* uri : {"../cube.bin", "/etc/passwd", "http://example.org/cube.bin", "file:///etc/passwd",
                          "cube.bin", "DATA:;base64,AAAA", ""}) {
    const std::string member = R"(,"uri":")" + std::string(uri) + "\"";
    expect_refused(gltf_json(R"([{"mesh":0}])", member), Code::file_format, uri);
    expect_refused(
        glb(gltf_json(R"([{"mesh":0}])", "", R"(,"images":[{"uri":")" + std::string(uri) + "\"}]")),
        Code::file_format, uri);
  }
}

TEST(Gltf, ImagesAreNotDecoded) {
  const auto mesh = read(glb(
      gltf_json(R"([{"mesh":0}])", "",
                R"(,"images":[{"uri":"data:image/png;base64,junk!"},{"bufferView":99,"mimeType":"x"}])")));
  EXPECT_TRUE(mesh) << mesh.error().text;
}

TEST(Gltf, DamagedDataUris) {
  const auto with = [](const std::string& uri) {
    return gltf_json(R"([{"mesh":0}])", ",\"uri\":\"" + uri + "\"");
  };
  expect_refused(with("data:,abc"), Code::file_format, "no base64");
  expect_refused(with("data:;base64"), Code::file_format, "no comma");
  expect_refused(with("data:;base64,A"), Code::file_truncated, "one digit");
  expect_refused(with("data:;base64,AA=A"), Code::file_format, "inner padding");
  expect_refused(with("data:;base64,AAAA"), Code::file_truncated, "three bytes");
  expect_refused(with("data:;base64," + std::string(224, '*')), Code::file_format, "no digits");
}

TEST(Gltf, SizesAndOffsetsAreChecked) {
  const std::vector<std::array<std::string, 2>> edits = {
      {"\"byteLength\":168", "\"byteLength\":169"},
      {"\"byteLength\":168", "\"byteLength\":18446744073709551615"},
      {"\"byteLength\":96}", "\"byteLength\":169}"},
      {"\"byteOffset\":96", "\"byteOffset\":97"},
      {"\"byteOffset\":96", "\"byteOffset\":18446744073709551615"},
      {"\"count\":8", "\"count\":9"},
      {"\"count\":8", "\"count\":4294967296"},
      {"\"count\":8", "\"count\":18446744073709551615"},
      {"\"count\":36", "\"count\":39"},
      {"\"count\":8", "\"byteOffset\":4,\"count\":8"},
      {"\"count\":8", "\"byteOffset\":18446744073709551612,\"count\":8"},
      {"\"byteLength\":96}", "\"byteLength\":96,\"byteStride\":16}"}};
  for (const auto& [from, to] : edits) expect_refused(glb(edited(from, to)), Code::file_truncated, to);
}

TEST(Gltf, NumbersOfTheWrongKindAreRefused) {
  const std::vector<std::array<std::string, 2>> edits = {
      {"\"byteLength\":96}", "\"byteLength\":96,\"byteStride\":8}"},
      {"\"byteLength\":96}", "\"byteLength\":96,\"byteStride\":0}"},
      {"\"byteOffset\":96", "\"byteOffset\":\"96\""},
      {"\"byteOffset\":96", "\"byteOffset\":-96"},
      {"\"byteOffset\":96", "\"byteOffset\":96.5"},
      {"\"count\":8,", ""},
      {"\"componentType\":5126", "\"componentType\":5125"},
      {"\"componentType\":5126", "\"componentType\":5124"},
      {"\"componentType\":5123", "\"componentType\":5122"},
      {"\"VEC3\"", "\"VEC4\""},
      {"\"VEC3\"", "7"},
      {"\"count\":36", "\"count\":35"},
      {"\"count\":8", "\"count\":8,\"sparse\":{}"},
      {"{\"bufferView\":0,", "{"},
      {"\"nodes\":[0]", "\"nodes\":0"},
      {"\"nodes\":[0]", "\"nodes\":[-1]"},
      {"\"indices\":1", "\"indices\":1,\"mode\":7"},
      {"\"indices\":1", "\"indices\":4294967297e0"},
      {"\"asset\":{\"version\":\"2.0\"},", ""}};
  for (const auto& [from, to] : edits) expect_refused(glb(edited(from, to)), Code::file_format, to);
  expect_refused(glb(edited("\"2.0\"", "\"1.0\"")), Code::file_version, "version");
}

TEST(Gltf, ReferencesAreChecked) {
  const std::vector<std::array<std::string, 2>> edits = {
      {"\"nodes\":[0]", "\"nodes\":[1]"},
      {"\"mesh\":0", "\"mesh\":1"},
      {"\"POSITION\":0", "\"POSITION\":2"},
      {"\"indices\":1", "\"indices\":4294967297"},
      {"\"bufferView\":1", "\"bufferView\":2"},
      {"\"buffer\":0,\"byteLength\"", "\"buffer\":1,\"byteLength\""},
      {"\"scene\":0", "\"scene\":1"},
      {"\"indices\":1", "\"indices\":1,\"material\":0"}};
  for (const auto& [from, to] : edits) expect_refused(glb(edited(from, to)), Code::bad_index, to);
  std::string buffer = samples::gltf_buffer();
  buffer.replace(96 + 2 * 4, 2, raw(std::uint16_t{8}));
  expect_refused(glb(gltf_json(), buffer), Code::bad_index, "vertex");
  EXPECT_EQ(read(glb(gltf_json(), buffer)).error().where, 1U);
}

TEST(Gltf, NodesFormATree) {
  expect_refused(glb(gltf_json(R"([{"children":[1]},{"children":[0]}])")), Code::file_format, "cycle");
  expect_refused(glb(gltf_json(R"([{"children":[0]}])")), Code::file_format, "own child");
  expect_refused(glb(gltf_json(R"([{"children":[1,2]},{"children":[2]},{"mesh":0}])")), Code::file_format,
                 "two parents");
  std::string chain = "[";
  for (int i = 1; i <= 20000; ++i) chain += R"({"children":[)" + std::to_string(i) + "]},";
  const auto deep = read(glb(gltf_json(chain + R"({"mesh":0}])")));
  ASSERT_TRUE(deep) << deep.error().text;
  EXPECT_EQ(deep->triangles.size(), 12U);
}

TEST(Gltf, DeepOrEndlessJsonIsRefused) {
  expect_refused(glb(gltf_json(R"([{"mesh":0}])", "", ",\"extras\":" + std::string(1000000, '['))),
                 Code::file_format, "arrays");
  std::string objects;
  for (int i = 0; i < 1000; ++i) objects += "{\"a\":";
  expect_refused("{\"a\":" + objects, Code::file_format, "objects");
  expect_refused("{\"asset\":1e999}", Code::file_format, "overflow");
  expect_refused("{\"asset\"", Code::file_truncated, "cut");
  expect_refused("{\"asset\":}", Code::file_format, "malformed");
}

TEST(Gltf, RepetitionWithoutEndIsRefused) {
  // 3000 nodes of a mesh of 3000 primitives of 12 triangles are 108 million triangles from 200 kB.
  std::string primitives, nodes = R"([{"children":[1)", meshes;
  for (int i = 0; i < 3000; ++i) primitives += R"(,{"attributes":{"POSITION":0},"indices":1})";
  for (int i = 2; i < 3000; ++i) nodes += "," + std::to_string(i);
  nodes += "]}";
  for (int i = 1; i < 3000; ++i) nodes += R"(,{"mesh":0})";
  std::string json = gltf_json(nodes + "]");
  json.replace(json.find("\"indices\":1}"), 12, "\"indices\":1}" + primitives);
  expect_refused(glb(json), Code::out_of_range, "repetition");
}

TEST(Gltf, GlbHeaderIsChecked) {
  const std::string good = glb(gltf_json());
  expect_refused(good + "xxxx", Code::file_format, "tail");
  std::string version = good;
  version.replace(4, 4, raw(std::uint32_t{1}));
  expect_refused(version, Code::file_version, "version");
  std::string chunk = good;
  chunk.replace(12, 4, raw(0xfffffff0U));
  expect_refused(chunk, Code::file_truncated, "chunk length");
  std::string type = good;
  type.replace(16, 4, "NOSJ");
  expect_refused(type, Code::file_format, "first chunk");
}

TEST(Gltf, TransformsAreAppliedFromParentToChild) {
  const auto mesh = read(glb(gltf_json(
      R"([{"children":[1],"translation":[10,0,0]},{"mesh":0,"rotation":[0,0,0.70710678118654757,0.70710678118654757],)"
      R"("scale":[2,3,4]}])")));
  ASSERT_TRUE(mesh) << mesh.error().text;
  const Vec3 p = mesh->vertices[6];  // (1,1,1) scaled, a quarter turn about z, moved
  EXPECT_NEAR(p.x, 7, 1e-14);
  EXPECT_NEAR(p.y, 2, 1e-14);
  EXPECT_EQ(p.z, 4);
  EXPECT_NEAR(audit(mesh->view())->volume, 24, 1e-12);
}

TEST(Gltf, MatrixIsColumnMajorAndAffine) {
  const auto mesh = read(glb(gltf_json(R"([{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]}])")));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->vertices[0], (Vec3{5, 6, 7}));
  expect_refused(glb(gltf_json(R"([{"mesh":0,"matrix":[1,0,0,1, 0,1,0,0, 0,0,1,0, 5,6,7,1]}])")),
                 Code::file_format, "perspective");
  expect_refused(glb(gltf_json(R"([{"mesh":0,"matrix":[1,0,0]}])")), Code::file_format, "short");
  expect_refused(glb(gltf_json(R"([{"mesh":0,"rotation":[0,0,0,0]}])")), Code::file_format, "no rotation");
  expect_refused(glb(gltf_json(R"([{"mesh":0,"scale":[1e70,1,1]}])")), Code::out_of_range, "scale");
}

TEST(Gltf, MirroredNodesKeepTheirNormalsOutward) {
  for (const char* node : {R"([{"mesh":0,"scale":[-1,1,1]}])", R"([{"mesh":0,"scale":[-2,-1,-1]}])",
                           R"([{"mesh":0,"matrix":[0,1,0,0, 1,0,0,0, 0,0,1,0, 0,0,0,1]}])",
                           R"([{"scale":[1,-1,1],"children":[1]},{"mesh":0}])",
                           R"([{"scale":[1,-1,1],"children":[1]},{"mesh":0,"scale":[1,1,-1]}])"}) {
    const auto mesh = read(glb(gltf_json(node)));
    ASSERT_TRUE(mesh) << node;
    const auto report = audit(mesh->view());
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->closed());
    EXPECT_GT(report->volume, 0.9) << node;
  }
}

TEST(Gltf, StripsAndFans) {
  const auto with_mode = [](const std::string& mode) {
    std::string json = edited("\"indices\":1", "\"mode\":" + mode);
    return read(glb(json));
  };
  const auto strip = with_mode("5");
  ASSERT_TRUE(strip);
  ASSERT_EQ(strip->triangles.size(), 6U);
  EXPECT_EQ(strip->triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(strip->triangles[1], (Triangle{1, 3, 2}));
  EXPECT_EQ(strip->triangles[2], (Triangle{2, 3, 4}));
  const auto fan = with_mode("6");
  ASSERT_TRUE(fan);
  ASSERT_EQ(fan->triangles.size(), 6U);
  EXPECT_EQ(fan->triangles[0], (Triangle{1, 2, 0}));
  EXPECT_EQ(fan->triangles[5], (Triangle{6, 7, 0}));
  EXPECT_TRUE(with_mode("1")->triangles.empty());
}

TEST(Gltf, MaterialsArePatchesInSceneOrder) {
  std::string json = gltf_json(R"([{"children":[2,1]},{"mesh":0},{"mesh":1,"translation":[9,0,0]}])", "",
                               R"(,"materials":[{"name":"steel"},{}])");
  const std::string first = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  const auto at = json.find(first);
  ASSERT_NE(at, std::string::npos);
  json.insert(at + first.size(),
              R"(,{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":1}]})");
  const auto mesh = read(glb(json));
  ASSERT_TRUE(mesh) << mesh.error().text;
  ASSERT_EQ(mesh->triangles.size(), 24U);
  EXPECT_EQ(mesh->vertices[mesh->triangles[0][0]].x, 9);
  EXPECT_EQ(mesh->patches.front(), 1U);
  EXPECT_EQ(mesh->patches.back(), 2U);
  EXPECT_EQ(mesh->patch_names, (std::vector<std::string>{"steel", "", ""}));
}

TEST(Gltf, WhatWouldMoveVerticesUnseenIsRefused) {
  expect_refused(
      glb(gltf_json(R"([{"mesh":0}])", "", R"(,"extensionsRequired":["KHR_draco_mesh_compression"])")),
      Code::file_format, "draco");
  EXPECT_TRUE(
      read(glb(gltf_json(R"([{"mesh":0}])", "", R"(,"extensionsRequired":["KHR_materials_unlit"])"))));
  expect_refused(glb(gltf_json(R"([{"mesh":0,"skin":0}])")), Code::file_format, "skin");
  expect_refused(glb(edited("{\"primitives\"", "{\"weights\":[0.5],\"primitives\"")), Code::file_format,
                 "morph");
}

TEST(Gltf, NoMeshIsEmptyAndMeshesWithoutSceneAreRefused) {
  const auto empty = read(R"({"asset":{"version":"2.0"}})");
  ASSERT_TRUE(empty) << empty.error().text;
  EXPECT_TRUE(empty->triangles.empty());
  expect_refused(glb(edited("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],", "")), Code::file_format, "no scene");
}

}  // namespace
}  // namespace cdfr
