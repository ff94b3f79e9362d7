#include <gtest/gtest.h>

#include <limits>

#include "mesh/samples.h"

namespace cdfr {
namespace {

using samples::raw;

Result<Mesh> read(const std::string& text) { return samples::read(text, ".ply"); }

std::string ascii(const std::string& elements, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string corners = "property list uchar int vertex_index\n";

TEST(Ply, PolygonsAreFansAndFacesMayComeFirst) {
  const auto mesh = read(ascii("element face 2\n" + corners + "element vertex 4\n" + xyz,
                               "4 0 1 2 3\n2 0 1\n0 0 0\n1 0 0\n1 1 0\n\n0 1 0\n"));
  ASSERT_TRUE(mesh) << mesh.error().text;
  EXPECT_EQ(mesh->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Ply, HugeCountsAreRefusedBeforeMemoryIsAsked) {
  for (const char* count : {"18446744073709551615", "9223372036854775807", "4294967294", "1000000000"}) {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      const std::string head = "ply\nformat " + std::string(format) + " 1.0\n";
      EXPECT_FALSE(read(head + "element vertex " + count + "\n" + xyz + "end_header\n0 0 0\n"));
      EXPECT_FALSE(read(head + "element vertex 0\n" + xyz + "element face " + count + "\n" + corners +
                        "end_header\n"));
      EXPECT_FALSE(read(head + "element odd " + count + "\nelement vertex 0\n" + xyz + "end_header\n"));
    }
  }
  const auto list =
      read("ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + xyz +
           "property list uint double more\nend_header\n" + std::string(12, '\0') + raw(0xffffffffU));
  ASSERT_FALSE(list);
  EXPECT_EQ(list.error().code, Code::file_truncated);
}

TEST(Ply, NegativeListCountsAreRefused) {
  const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + xyz +
                           "element face 1\nproperty list char int vertex_indices\nend_header\n";
  const auto mesh = read(head + std::string(12, '\0') + raw(std::int8_t{-1}));
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, Code::file_format);
}

TEST(Ply, IndicesAreChecked) {
  for (const char* face : {"3 0 1 3", "3 0 1 -1", "3 0 1 4294967296"}) {
    const auto mesh = read(ascii("element vertex 3\n" + xyz + "element face 1\n" + corners,
                                 "0 0 0\n1 0 0\n0 1 0\n" + std::string(face) + "\n"));
    ASSERT_FALSE(mesh) << face;
    EXPECT_EQ(mesh.error().code, Code::bad_index) << face;
    EXPECT_EQ(mesh.error().where, 13U) << mesh.error().text;
  }
}

TEST(Ply, CoordinatesAreChecked) {
  const auto vertex = [](const std::string& numbers) {
    return read(
        ascii("element vertex 2\nproperty double x\nproperty double y\nproperty double z\nproperty float q\n",
              "0 0 0 nan\n" + numbers + " nan\n"));
  };
  EXPECT_TRUE(vertex("1 2 3"));
  for (const auto& [numbers, code] :
       std::vector<std::pair<std::string, Code>>{{"nan 0 0", Code::not_finite},
                                                 {"0 inf 0", Code::not_finite},
                                                 {"0 0 1e80", Code::out_of_range},
                                                 {"0 0 1e-400", Code::out_of_range},
                                                 {"0 0 1e-100", Code::out_of_range}}) {
    const auto mesh = vertex(numbers);
    ASSERT_FALSE(mesh) << numbers;
    EXPECT_EQ(mesh.error().code, code) << numbers;
    EXPECT_EQ(mesh.error().where, 1U) << numbers;
  }
  EXPECT_EQ(vertex("1,5 0 0").error().code, Code::file_format);
}

TEST(Ply, RowsHaveExactlyTheirValues) {
  const std::string elements = "element vertex 2\n" + xyz;
  EXPECT_TRUE(read(ascii(elements, "0 0 0\n1 1 1")));
  EXPECT_EQ(read(ascii(elements, "0 0\n1.25 1.25 1.25\n")).error().code, Code::file_format);
  EXPECT_EQ(read(ascii(elements, "0 0 0 0\n1 1 1\n")).error().code, Code::file_format);
  EXPECT_EQ(read(ascii(elements, "0 0 0\n1 1 1\n2 2 2\n")).error().code, Code::file_format);
  EXPECT_EQ(read(ascii(elements, "0 0 0\n")).error().code, Code::file_truncated);
}

TEST(Ply, BinaryTailIsRefused) {
  EXPECT_EQ(read(samples::binary_ply(std::endian::little) + "x").error().code, Code::file_format);
}

TEST(Ply, HeadersAreChecked) {
  const std::string vertices = "element vertex 0\n" + xyz;
  EXPECT_TRUE(read(ascii("comment any\nobj_info any\n" + vertices, "")));
  for (const std::string& elements :
       {std::string(), std::string("element face 0\n"), std::string("element vertex 0\nproperty float x\n"),
        vertices + vertices, vertices + "property float x\n", vertices + "property text t\n",
        vertices + "property list float int l\n", vertices + "element face -1\n" + corners,
        vertices + "element face 1\nproperty list uchar float vertex_indices\n",
        vertices + "format ascii 1.0\n", vertices + "element face 1\nproperty int a\n",
        "property float x\n" + vertices, vertices + "whatever\n",
        vertices + "element tristrips 1\nproperty list int int vertex_indices\n"}) {
    const auto mesh = read(ascii(elements, "0\n"));
    ASSERT_FALSE(mesh) << elements;
    EXPECT_EQ(mesh.error().code, Code::file_format) << elements;
  }
  EXPECT_EQ(read("ply\nformat ascii 2.0\nend_header\n").error().code, Code::file_version);
  EXPECT_EQ(read("ply\nformat middle_endian 1.0\nend_header\n").error().code, Code::file_format);
}

TEST(Ply, CrlfHeaderBeforeBinaryBody) {
  const auto mesh = read(
      "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 1\r\nproperty float x\r\n"
      "property float y\r\nproperty float z\r\nend_header\r\n" +
      raw(1.0F) + raw(2.0F) + raw(3.0F));
  ASSERT_TRUE(mesh) << mesh.error().text;
  EXPECT_EQ(mesh->vertices[0], (Vec3{1, 2, 3}));
}

}  // namespace
}  // namespace cdfr
