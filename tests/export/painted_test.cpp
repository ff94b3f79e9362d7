/// Painted meshes: what is refused, colours, and the PLY.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cdfr/export/painted.h"
#include "cdfr/export/write.h"
#include "cdfr/mesh/read.h"
#include "export/painted_case.h"
#include "export/ply_parse.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

constexpr double nan = PaintedCase::nan, infinity = PaintedCase::infinity;
const std::vector<std::string> formats{"a.ply", "a.vtp", "a.glb"};

class PaintedTest : public ScratchTest {
 protected:
  std::string written(const PaintedMesh& painted, const std::string& name) {
    const auto result = write_painted(painted, folder() / name);
    EXPECT_TRUE(result) << result.error().text;
    return text_of(folder() / name);
  }
  void expect_refused(const std::function<void(PaintedMesh&)>& spoil, Code code) {
    const PaintedCase whole;
    for (const std::string& name : formats) {
      PaintedMesh painted = whole.painted();
      spoil(painted);
      const auto result = write_painted(painted, folder() / name);
      ASSERT_FALSE(result) << name;
      EXPECT_EQ(result.error().code, code) << result.error().text;
    }
    EXPECT_TRUE(names().empty());
  }
};

TEST_F(PaintedTest, BadInputIsRefusedByNameAndLeavesNoFile) {
  const std::vector<double> short_array(3);
  for (const char* name : {"", "1a", "a b", "x", "red", "patch", "radius", "a\"b", "a<b", "\xc3\xa4"}) {
    SCOPED_TRACE(name);
    expect_refused([&](PaintedMesh& p) { p.arrays[1].name = name; }, Code::bad_option);
  }
  expect_refused([](PaintedMesh& p) { p.arrays[1].name = std::string(64, 'a'); }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.arrays[1].name = "thickness"; }, Code::bad_option);
  expect_refused([&](PaintedMesh& p) { p.arrays[2].values = short_array; }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.painted = "unknown"; }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.least = 12; }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.greatest = infinity; }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.least = nan; }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.balls[0].radius = 0; }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.balls[1].centre.z = nan; }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.balls[1] = {{1.7e308, 0, 0}, 1e308}; }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.labels[1].place.x = -infinity; }, Code::bad_option);
  expect_refused([](PaintedMesh& p) { p.mesh.patches = p.mesh.patches.subspan(1); }, Code::bad_option);
}

TEST_F(PaintedTest, BadMeshExtensionAndScaleAreRefused) {
  PaintedCase bad_index, not_finite;
  bad_index.mesh.triangles[2][1] = 4;
  not_finite.mesh.vertices[3].y = nan;
  for (const std::string& name : formats) {
    const auto index_result = write_painted(bad_index.painted(), folder() / name);
    ASSERT_FALSE(index_result);
    EXPECT_EQ(index_result.error().code, Code::bad_index);
    const auto finite_result = write_painted(not_finite.painted(), folder() / name);
    ASSERT_FALSE(finite_result);
    EXPECT_EQ(finite_result.error().code, Code::not_finite);
    for (const double metres : {0.0, -1.0, nan, infinity})
      EXPECT_FALSE(write_painted(PaintedCase().painted(), folder() / name, metres));
  }
  for (const char* name : {"a.stl", "a.obj", "a", "a.vtu", "a.gltf"}) {
    const auto result = write_painted(PaintedCase().painted(), folder() / name);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Code::bad_option);
  }
  EXPECT_TRUE(names().empty());
  const auto no_folder = write_painted(PaintedCase().painted(), folder() / "none" / "a.vtp");
  ASSERT_FALSE(no_folder);
  EXPECT_EQ(no_folder.error().code, Code::file_write);
}

TEST_F(PaintedTest, PlyHoldsEveryBitOfTheNumbersAndTheirColours) {
  const PaintedCase made;
  const PlyParse ply(written(made.painted(), "a.ply"));
  ASSERT_EQ(ply.elements.size(), 2U);
  EXPECT_EQ(ply.elements[0].properties,
            (std::vector<std::string>{"double x", "double y", "double z", "double thickness", "double error",
                                      "uchar red", "uchar green", "uchar blue"}));
  EXPECT_EQ(ply.elements[1].properties, (std::vector<std::string>{"list uchar uint vertex_indices",
                                                                  "uint patch", "double depth_of_face"}));
  for (std::size_t i = 0; i < made.mesh.vertices.size(); ++i) {
    const std::vector<double>& row = ply.elements[0].rows[i];
    EXPECT_EQ(std::bit_cast<std::uint64_t>(row[3]), std::bit_cast<std::uint64_t>(made.thickness[i]));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(row[4]), std::bit_cast<std::uint64_t>(made.error[i]));
    const Colour colour = painted_colour(made.thickness[i], 1, 11);
    EXPECT_EQ((std::vector<double>{row[5], row[6], row[7]}),
              (std::vector<double>{double(colour[0]), double(colour[1]), double(colour[2])}));
  }
  EXPECT_EQ(ply.elements[1].rows[3][4], 1e300);
  EXPECT_EQ(ply.comments, (std::vector<std::string>{"written by cdfr",
                                                    "painted: thickness from 1 (yellow) to 11 (dark blue) mm",
                                                    "sha256: 00ff", "two lines"}));
}

TEST_F(PaintedTest, PlyIsAMeshForTheLibrarysOwnReader) {
  PaintedCase made;
  made.painted_array = "depth_of_face";
  written(made.painted(), "a.ply");
  const auto mesh = read_mesh(folder() / "a.ply");
  ASSERT_TRUE(mesh) << mesh.error().text;
  EXPECT_EQ(mesh->vertices, made.mesh.vertices);
  EXPECT_EQ(mesh->triangles, made.mesh.triangles);
}

TEST_F(PaintedTest, UnpaintedPlyIsThatOfWriteMesh) {
  const PaintedCase made;
  const std::string painted = written(PaintedMesh{made.mesh.view()}, "a.ply");
  ASSERT_TRUE(write_mesh(made.mesh.view(), folder() / "b.ply"));
  EXPECT_EQ(painted, text_of(folder() / "b.ply"));
}

TEST_F(PaintedTest, EmptyMeshesAndTheSameBytesTwice) {
  for (const std::string& name : formats) {
    written({}, "empty" + name);
    const PaintedCase made;
    EXPECT_EQ(written(made.painted(), name), written(made.painted(), "again" + name)) << name;
  }
}

/// Arrays in memory that nobody may touch: the counts alone must be enough to refuse.
TEST_F(PaintedTest, GlbBeyondFourGibibytesIsRefusedUnread) {
  const std::size_t count = (std::size_t{1} << 32) / 84 + 1;
  const std::size_t bytes = count * sizeof(Triangle);
  void* memory = ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) GTEST_SKIP() << "no address space for " << bytes << " bytes";
  const std::vector<Vec3> vertices(3);
  PaintedMesh painted;
  painted.mesh.vertices = std::span<const Vec3>(vertices);
  painted.mesh.triangles = {static_cast<const Triangle*>(memory), count};
  painted.arrays = {{"a", ArrayPlace::face, {static_cast<const double*>(memory), count}}};
  painted.painted = "a";
  const auto refused = write_painted(painted, folder() / "a.glb");
  ::munmap(memory, bytes);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::file_write);
  EXPECT_NE(refused.error().text.find("4 GiB"), std::string::npos);
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace cdfr
