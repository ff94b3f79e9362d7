#include "mesh/large_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>
#include <string>

#include "cdfr/export/write.h"
#include "cdfr/mesh/flip.h"
#include "cdfr/mesh/read.h"
#include "mesh/samples.h"
#include "support/meshes.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

class LargeMeshTest : public ScratchTest {
 protected:
  Result<LargeMesh> read(const std::filesystem::path& path, bool flipped = false, const cdfr::Run& run = {}) {
    Progress progress(run);
    return read_large_mesh(path, scratch(), flipped, progress);
  }
  const Scratch& scratch() {
    if (!scratch_) scratch_.emplace(folder());
    return *scratch_;
  }

  void expect_what_read_mesh_reads(const std::filesystem::path& path) {
    for (const bool flipped : {false, true}) {
      Mesh mesh = read_mesh(path).value();
      if (flipped) flip(mesh);
      const LargeMesh large = read(path, flipped).value();
      EXPECT_TRUE(std::ranges::equal(large.triangles, mesh.triangles)) << path;
      EXPECT_TRUE(std::ranges::equal(large.patches, mesh.patches)) << path;
      EXPECT_EQ(large.patch_names, mesh.patch_names) << path;
      // Bits: -0 is not 0.
      const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
      EXPECT_TRUE(std::ranges::equal(large.vertices, mesh.vertices, [&](const Vec3& a, const Vec3& b) {
        return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
      })) << path;
      const MeshView view = large.view();
      EXPECT_EQ(view.vertices.size(), mesh.vertices.size());
      EXPECT_EQ(view.triangles.data(), large.triangles.data());
      EXPECT_EQ(view.patches.size(), mesh.patches.size());
    }
  }

 private:
  std::optional<Scratch> scratch_;
};

TEST_F(LargeMeshTest, IsWhatReadMeshReadsInEveryFormat) {
  for (const samples::Sample& sample : samples::all()) {
    const auto path = folder() / ("cube" + sample.extension);
    put_text(path, sample.bytes);
    expect_what_read_mesh_reads(path);
  }
  put_text(folder() / "cube.obj", "g one\nv -0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\ng two\nf 1 3 4\n");
  expect_what_read_mesh_reads(folder() / "cube.obj");
  put_text(folder() / "solid.stl", samples::binary_stl("solid by name only"));
  expect_what_read_mesh_reads(folder() / "solid.stl");
}

/// Of 131,072 triangles, so that more than one piece is read.
TEST_F(LargeMeshTest, OfManyPiecesIsWhatReadMeshReads) {
  const Mesh sphere = test::sphere_mesh(7, 3, {1, -2, 0.5});
  for (const char* name : {"sphere.stl", "sphere.ply"}) {
    ASSERT_TRUE(write_mesh(sphere.view(), folder() / name));
    expect_what_read_mesh_reads(folder() / name);
  }
}

TEST_F(LargeMeshTest, FaultsAreReadMeshs) {
  const auto expect_same_error = [&](const std::filesystem::path& path) {
    const Result<Mesh> plain = read_mesh(path);
    const Result<LargeMesh> large = read(path);
    ASSERT_FALSE(plain);
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().code, plain.error().code);
    EXPECT_EQ(large.error().where, plain.error().where);
    EXPECT_EQ(large.error().text, plain.error().text);
  };
  expect_same_error(folder() / "missing.stl");
  put_text(folder() / "short.stl", samples::binary_stl().substr(0, 400));
  expect_same_error(folder() / "short.stl");
  put_text(folder() / "text.txt", "no mesh");
  expect_same_error(folder() / "text.txt");
  put_text(folder() / "bad.obj", "v 0 0 0\nf 1 2 3\n");
  expect_same_error(folder() / "bad.obj");

  ASSERT_TRUE(write_mesh(test::sphere_mesh(7).view(), folder() / "nan.stl"));
  std::string bytes = text_of(folder() / "nan.stl");
  constexpr std::size_t triangle = 70000;
  bytes.replace(84 + 50 * triangle + 12, 4, samples::raw(std::numeric_limits<float>::quiet_NaN()));
  put_text(folder() / "nan.stl", bytes);
  expect_same_error(folder() / "nan.stl");
  EXPECT_EQ(read(folder() / "nan.stl").error().where, triangle);
}

TEST_F(LargeMeshTest, IsCancelled) {
  const Mesh sphere = test::sphere_mesh(2);
  const cdfr::Run run{1, [](void*, double) noexcept { return false; }, nullptr};
  for (const char* name : {"sphere.stl", "sphere.obj"}) {
    ASSERT_TRUE(write_mesh(sphere.view(), folder() / name));
    const Result<LargeMesh> large = read(folder() / name, false, run);
    ASSERT_FALSE(large) << name;
    EXPECT_EQ(large.error().code, Code::cancelled);
  }
}

}  // namespace
}  // namespace cdfr
