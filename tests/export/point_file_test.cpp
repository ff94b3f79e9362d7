#include <gtest/gtest.h>
#include <sys/mman.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "cdfr/export/write.h"
#include "export/ply_parse.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<ContourPoint> spiral(std::size_t count) {
  std::vector<ContourPoint> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / 7;
    points[i].position = {1e6 + t, -t * t, 1 / (t + 3)};
    points[i].normal = {0.6, 0, i % 2 == 0 ? 0.8 : -0.8};
    points[i].triangle = i == 2 ? no_index : static_cast<std::uint32_t>(i * 1000003);
    points[i].error = t * 1e-9;
  }
  return points;
}

class PointFileTest : public ScratchTest {
 protected:
  /// The file's bytes when the points come in blocks of the given length.
  std::string written(const std::string& name, std::span<const ContourPoint> points, std::size_t block) {
    auto file = create_point_file(folder() / name, 0.001);
    if (!file) return ADD_FAILURE() << file.error().text, "";
    EXPECT_TRUE((*file)->write({}));
    for (std::size_t i = 0; i < points.size(); i += block) {
      EXPECT_TRUE((*file)->write(points.subspan(i, std::min(block, points.size() - i))));
    }
    const auto finished = (*file)->finish();
    EXPECT_TRUE(finished) << finished.error().text;
    return text_of(folder() / name);
  }
};

TEST_F(PointFileTest, BadOptionsAreRefusedAndLeaveNoFile) {
  for (const char* name : {"a.stl", "a.obj", "a.vtp", "a", "a.gltf"}) {
    const auto file = create_point_file(folder() / name);
    ASSERT_FALSE(file) << name;
    EXPECT_EQ(file.error().code, Code::bad_option);
  }
  for (const double metres : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    const auto file = create_point_file(folder() / "a.glb", metres);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, Code::bad_option);
  }
  EXPECT_TRUE(names().empty());
  const auto file = create_point_file(folder() / "none" / "a.ply");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, Code::file_write);
}

TEST_F(PointFileTest, WithoutFinishNothingStays) {
  for (const char* name : {"a.ply", "a.csv", "a.glb"}) {
    auto file = create_point_file(folder() / name);
    ASSERT_TRUE(file);
    ASSERT_TRUE((*file)->write(spiral(10000)));
  }
  EXPECT_TRUE(names().empty());
}

TEST_F(PointFileTest, PointThatIsNotFiniteEndsTheFile) {
  for (const char* name : {"a.ply", "a.csv", "a.glb"}) {
    auto points = spiral(5);
    points[3].normal.y = infinity;
    auto file = create_point_file(folder() / name);
    ASSERT_TRUE(file);
    ASSERT_TRUE((*file)->write(spiral(10)));
    const auto refused = (*file)->write(points);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Code::not_finite);
    EXPECT_EQ(refused.error().where, 13U);
    EXPECT_FALSE((*file)->write(spiral(1)));
    EXPECT_FALSE((*file)->finish());
  }
  EXPECT_TRUE(names().empty());
}

TEST_F(PointFileTest, BytesDoNotDependOnTheBlocks) {
  const auto points = spiral(1000);
  for (const char* name : {"a.ply", "a.csv", "a.glb"}) {
    const std::string whole = written(name, points, points.size());
    EXPECT_TRUE(whole == written(name, points, 1)) << name;
    EXPECT_TRUE(whole == written(name, points, 333)) << name;
  }
}

TEST_F(PointFileTest, PlyHasTheDocumentedColumns) {
  const std::vector<std::string> columns = {"double x",  "double y",  "double z",     "double nx",
                                            "double ny", "double nz", "double error", "uint triangle"};
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1234}}) {
    const auto points = spiral(count);
    const std::string bytes = written("a.ply", points, 100);
    const PlyParse ply(bytes);
    ASSERT_EQ(ply.elements.size(), 1U);
    EXPECT_EQ(ply.elements[0].name, "vertex");
    EXPECT_EQ(ply.elements[0].properties, columns);
    ASSERT_EQ(ply.elements[0].rows.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [p, n, triangle, error] = points[i];
      EXPECT_EQ(ply.elements[0].rows[i],
                (std::vector<double>{p.x, p.y, p.z, n.x, n.y, n.z, error, static_cast<double>(triangle)}));
    }
  }
}

TEST_F(PointFileTest, CsvHasTheDocumentedColumnsAndEveryDigit) {
  const auto points = spiral(100);
  std::istringstream lines(written("a.csv", points, 30));
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line, "x,y,z,nx,ny,nz,triangle,error");
  for (const auto& [p, n, triangle, error] : points) {
    ASSERT_TRUE(std::getline(lines, line));
    std::istringstream fields(line);
    std::vector<double> row;
    for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
    EXPECT_EQ(row, (std::vector<double>{p.x, p.y, p.z, n.x, n.y, n.z, static_cast<double>(triangle), error}));
  }
  EXPECT_FALSE(std::getline(lines, line));
  EXPECT_EQ(written("b.csv", {}, 1), "x,y,z,nx,ny,nz,triangle,error\n");
}

/// A span over memory that nobody may touch: the count alone must be enough to refuse.
TEST_F(PointFileTest, GlbBeyondFourGibibytesIsRefusedUnread) {
  const std::size_t count = (std::size_t{1} << 32) / 24 + 1;
  const std::size_t bytes = count * sizeof(ContourPoint);
  void* memory = ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) GTEST_SKIP() << "no address space for " << bytes << " bytes";
  auto file = create_point_file(folder() / "a.glb");
  ASSERT_TRUE(file);
  const auto refused = (*file)->write({static_cast<const ContourPoint*>(memory), count});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::file_write);
  EXPECT_NE(refused.error().text.find("4 GiB"), std::string::npos);
  EXPECT_FALSE((*file)->finish());
  ::munmap(memory, bytes);
}

TEST_F(PointFileTest, GlbOfPointsTooFarApartForFloatIsRefused) {
  std::vector<ContourPoint> points(2);
  points[1].position.x = 1e60;
  auto file = create_point_file(folder() / "a.glb");
  ASSERT_TRUE(file);
  const auto refused = (*file)->write(points);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::file_write);
  EXPECT_FALSE((*file)->finish());
}

}  // namespace
}  // namespace cdfr
