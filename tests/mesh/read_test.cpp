// What every reader promises, whatever the format.
#include "cdfr/mesh/read.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "cdfr/mesh/audit.h"
#include "mesh/samples.h"

namespace cdfr {
namespace {

/// A small generator of our own, so that a failure comes back with the same numbers everywhere.
class Random {
 public:
  std::uint64_t next() noexcept {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_ = 42;
};

/// Whatever came back: a mesh that holds together, or an error of one line.
void expect_sound(const Result<Mesh>& mesh) {
  if (!mesh) {
    EXPECT_NE(mesh.error().code, Code{});
    EXPECT_FALSE(mesh.error().text.empty());
    for (const char c : mesh.error().text) EXPECT_TRUE(c >= ' ' && c <= '~') << mesh.error().text;
    return;
  }
  EXPECT_TRUE(mesh->patches.empty() || mesh->patches.size() == mesh->triangles.size());
  for (const auto patch : mesh->patches) EXPECT_LT(patch, mesh->patch_names.size());
  const auto report = audit(mesh->view());
  EXPECT_TRUE(report || report.error().code == Code::empty_mesh) << report.error().text;
}

TEST(Read, EveryFormatGivesTheSameCube) {
  for (const auto& sample : samples::all()) {
    const auto mesh = samples::read(sample.bytes, sample.extension);
    ASSERT_TRUE(mesh) << sample.name << ": " << mesh.error().text;
    const auto triangles = samples::cube_triangles();
    ASSERT_EQ(mesh->triangles.size(), triangles.size()) << sample.name;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(mesh->vertices[mesh->triangles[t][k]], samples::cube_vertices()[triangles[t][k]])
            << sample.name << " triangle " << t;
      }
    }
    const auto report = audit(mesh->view());
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->closed()) << sample.name;
    EXPECT_DOUBLE_EQ(report->volume, 1) << sample.name;
  }
}

TEST(Read, ContentTellsTheFormatWithoutTheName) {
  for (const auto& sample : samples::all()) {
    const bool read = static_cast<bool>(samples::read(sample.bytes, ""));
    EXPECT_EQ(read, sample.name != "OBJ") << sample.name;
    EXPECT_EQ(static_cast<bool>(samples::read(sample.bytes, ".obj")), true) << sample.name;
  }
}

TEST(Read, EveryTruncationIsAnErrorOrAPrefix) {
  for (const auto& sample : samples::all()) {
    const std::size_t whole = samples::read(sample.bytes, sample.extension)->triangles.size();
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      SCOPED_TRACE(sample.name + " cut at " + std::to_string(size));
      const auto mesh = samples::read(std::string_view(sample.bytes).substr(0, size), sample.extension);
      expect_sound(mesh);
      if (mesh) {
        EXPECT_LE(mesh->triangles.size(), whole);
      }
      const bool text = sample.name == "OBJ" || sample.name == "ASCII STL" || sample.name == "ASCII PLY";
      if (!text) {
        EXPECT_FALSE(mesh);
      }
    }
  }
}

TEST(Read, RandomDamageNeverCrashes) {
  Random random;
  for (const auto& sample : samples::all()) {
    for (int round = 0; round < 1500; ++round) {
      std::string bytes = sample.bytes;
      const std::uint64_t changes = 1 + random.next() % 4;
      for (std::uint64_t i = 0; i < changes; ++i) {
        bytes[random.next() % bytes.size()] = static_cast<char>(random.next());
      }
      SCOPED_TRACE(sample.name + " round " + std::to_string(round));
      expect_sound(samples::read(bytes, sample.extension));
    }
  }
}

TEST(Read, RandomBytesNeverCrash) {
  Random random;
  for (const char* start : {"", "solid ", "ply\n", "glTF", "{", "v 1 2 3\n"}) {
    for (int round = 0; round < 200; ++round) {
      std::string bytes = start;
      for (std::uint64_t size = random.next() % 200; size > 0; --size)
        bytes += static_cast<char>(random.next());
      for (const char* extension : {"", ".stl", ".obj", ".ply", ".gltf", ".glb"}) {
        expect_sound(samples::read(bytes, extension));
      }
    }
  }
}

TEST(Read, UnknownAndCompressedFilesAreRefused) {
  for (const std::string& bytes : {std::string("\x1f\x8b\x08 pack"), std::string("hello"), std::string()}) {
    const auto mesh = samples::read(bytes, ".gz");
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, Code::file_format);
  }
  EXPECT_NE(samples::read("\x1f\x8b\x08 pack", ".stl").error().text.find("gzip"), std::string::npos);
}

class ReadFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "cdfr-read-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(ReadFiles, OnlyRegularFilesAreOpened) {
  ASSERT_EQ(::mkfifo((folder_ / "fifo.stl").c_str(), 0600), 0);
  for (const auto& path :
       {folder_ / "fifo.stl", folder_, folder_ / "missing.obj", std::filesystem::path("/dev/zero")}) {
    const auto mesh = read_mesh(path);
    ASSERT_FALSE(mesh) << path;
    EXPECT_EQ(mesh.error().code, Code::file_open);
    const auto points = read_points(path);
    ASSERT_FALSE(points) << path;
    EXPECT_EQ(points.error().code, Code::file_open);
  }
}

TEST_F(ReadFiles, UpperCaseExtensionsAreKnown) {
  std::ofstream(folder_ / "CUBE.OBJ") << samples::obj();
  const auto mesh = read_mesh(folder_ / "CUBE.OBJ");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->triangles.size(), 12U);
}

TEST(Read, LocaleDoesNotChangeNumbers) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool found = false;
  for (const char* name :
       {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR.utf8", "nl_NL.UTF-8"}) {
    found = found || std::setlocale(LC_ALL, name) != nullptr;
  }
  if (!found) GTEST_SKIP() << "no locale with a decimal comma is installed";
  const auto mesh = samples::read("v 1.5 0 0\nv 0 2.25 0\nv 0 0 1e-1\nf 1 2 3\n", ".obj");
  const auto comma = samples::read("v 1,5 0 0\n", ".obj");
  const auto moved =
      samples::read(samples::glb(samples::gltf_json(R"([{"mesh":0,"translation":[0.5,0,0]}])")));
  std::setlocale(LC_ALL, before.c_str());
  ASSERT_TRUE(mesh && moved);
  EXPECT_EQ(mesh->vertices[0].x, 1.5);
  EXPECT_EQ(mesh->vertices[1].y, 2.25);
  EXPECT_EQ(mesh->vertices[2].z, 0.1);
  EXPECT_EQ(moved->vertices[0].x, 0.5);
  EXPECT_FALSE(comma);
}

}  // namespace
}  // namespace cdfr
