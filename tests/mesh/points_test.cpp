#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "cdfr/mesh/read.h"
#include "mesh/samples.h"

namespace cdfr {
namespace {

using samples::raw;

Result<std::vector<Vec3>> read(const std::string& text) {
  return read_points_bytes(samples::ExactBytes(text).span());
}

std::string npy(const std::string& dictionary, const std::string& data, int version = 1) {
  std::string header = dictionary + "\n";
  const auto size = header.size();
  return std::string("\x93NUMPY") + static_cast<char>(version) + '\0' +
         (version == 1 ? raw(static_cast<std::uint16_t>(size)) : raw(static_cast<std::uint32_t>(size))) +
         header + data;
}

std::string dictionary(const std::string& type, const std::string& order, const std::string& shape) {
  return "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
}

const std::vector<Vec3> two = {{1, 2, 3}, {4, 5, 6.5}};

TEST(PointsCsv, WithAndWithoutHeader) {
  for (const char* text :
       {"1,2,3\n4,5,6.5\n", "x,y,z\n1,2,3\n4,5,6.5", " X , \"y\",Z,name\r\n1, 2 ,3,a,b\r\n\r\n4,5,6.5,\r\n",
        "\xef\xbb\xbfx,y,z\n+1,2e0,3\n4,5,6.5\n"}) {
    const auto points = read(text);
    ASSERT_TRUE(points) << text << points.error().text;
    EXPECT_EQ(*points, two) << text;
  }
  EXPECT_TRUE(read("")->empty());
  EXPECT_TRUE(read("x,y,z\n")->empty());
}

TEST(PointsCsv, DamageNamesTheLine) {
  for (const auto& [line, code] :
       std::vector<std::pair<std::string, Code>>{{"1,2", Code::file_format},
                                                 {"1;2;3", Code::file_format},
                                                 {"1,2,", Code::file_format},
                                                 {"x,y,z", Code::file_format},
                                                 {"1,nan,3", Code::not_finite},
                                                 {"1,2,1e300", Code::out_of_range}}) {
    const auto points = read("0,0,0\n" + line + "\n");
    ASSERT_FALSE(points) << line;
    EXPECT_EQ(points.error().code, code) << line;
    EXPECT_EQ(points.error().where, 2U) << line;
  }
  EXPECT_FALSE(read("distance,cx,cy,cz\n1,2,3,4\n"));
}

TEST(PointsNpy, AllLayouts) {
  std::string doubles, floats, columns;
  for (const auto& p : two) {
    doubles += raw(p.x) + raw(p.y) + raw(p.z);
    floats += raw(static_cast<float>(p.x)) + raw(static_cast<float>(p.y)) + raw(static_cast<float>(p.z));
  }
  for (const double x : {1.0, 4.0, 2.0, 5.0, 3.0, 6.5}) columns += raw(x);
  for (const std::string& bytes : {npy(dictionary("<f8", "False", "(2, 3)"), doubles),
                                   npy(dictionary("<f4", "False", "(2,3)"), floats, 2),
                                   npy(dictionary("<f8", "True", "(2, 3)"), columns, 3)}) {
    const auto points = read(bytes);
    ASSERT_TRUE(points) << points.error().text;
    EXPECT_EQ(*points, two);
    for (std::size_t size = 6; size < bytes.size(); ++size) {
      EXPECT_FALSE(read(bytes.substr(0, size))) << size;
    }
    EXPECT_EQ(read(bytes + "x").error().code, Code::file_format);
  }
}

TEST(PointsNpy, OtherArraysAreRefused) {
  for (const std::string& header :
       {dictionary(">f8", "False", "(0, 3)"), dictionary("<i4", "False", "(0, 3)"),
        dictionary("|O", "False", "(0, 3)"), dictionary("<f8", "Maybe", "(0, 3)"),
        dictionary("<f8", "False", "(0, 4)"), dictionary("<f8", "False", "(0,)"),
        dictionary("<f8", "False", "(0, 3, 1)"), dictionary("<f8", "False", "(-1, 3)"), std::string("{"),
        std::string()}) {
    EXPECT_EQ(read(npy(header, "")).error().code, Code::file_format) << header;
  }
  EXPECT_EQ(read(npy(dictionary("<f8", "False", "(1000000000, 3)"), "")).error().code, Code::file_truncated);
  EXPECT_EQ(read(npy(dictionary("<f8", "False", "(9000000000000000000, 3)"), "")).error().code,
            Code::out_of_range);
  EXPECT_EQ(read(npy("", "", 9)).error().code, Code::file_version);
}

TEST(PointsPly, VerticesAreThePoints) {
  const auto points = read(samples::binary_ply(std::endian::big));
  ASSERT_TRUE(points);
  EXPECT_EQ(*points, samples::cube_vertices());
}

/// Puts a file in place of standard input while it lives.
class StandardInput {
 public:
  explicit StandardInput(const std::string& text) : saved_(::dup(STDIN_FILENO)) {
    std::FILE* file = std::tmpfile();
    std::fputs(text.c_str(), file);
    std::fflush(file);
    ::lseek(::fileno(file), 0, SEEK_SET);
    ::dup2(::fileno(file), STDIN_FILENO);
    std::fclose(file);
  }
  ~StandardInput() {
    ::dup2(saved_, STDIN_FILENO);
    ::close(saved_);
  }

 private:
  int saved_;
};

TEST(PointsStandardInput, IsCsv) {
  std::string text = "x,y,z\n";
  for (int i = 0; i < 20000; ++i) text += std::to_string(i) + ",0.5,-2\n";
  const StandardInput input(text + "7,8,9");
  const auto points = read_points("-");
  ASSERT_TRUE(points) << points.error().text;
  ASSERT_EQ(points->size(), 20001U);
  EXPECT_EQ((*points)[19999].x, 19999);
  EXPECT_EQ(points->back(), (Vec3{7, 8, 9}));
}

TEST(PointsStandardInput, ALineWithoutEndIsRefused) {
  const StandardInput input(std::string(3 << 20, '1'));
  const auto points = read_points("-");
  ASSERT_FALSE(points);
  EXPECT_EQ(points.error().code, Code::file_format);
}

}  // namespace
}  // namespace cdfr
