/// grid: known distances of a cube with an edge of 5, the same numbers in each format.
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

#include "cli/program.h"

namespace cdfr {
namespace {

class GridTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    cube_ = part("cube", "cube.stl");
  }
  std::string cube_;
};

double number_at(const std::string& bytes, std::size_t offset) {
  double value = NAN;
  if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

TEST_F(GridTest, NpyHasTheKnownDistances) {
  const Outcome outcome = run({"grid", cube_, "--resolution", "11", "-o", path("a.npy")});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const std::string npy = text_of("a.npy");
  EXPECT_NE(npy.find("'shape': (11, 11, 11)"), std::string::npos);
  constexpr std::size_t header = 128;
  ASSERT_EQ(npy.size(), header + 1331 * 8);
  const auto distance = [&](std::size_t i, std::size_t j, std::size_t k) {
    return number_at(npy, header + 8 * ((k * 11 + j) * 11 + i));
  };
  EXPECT_EQ(distance(5, 5, 5), -2.5);
  EXPECT_EQ(distance(1, 5, 5), -0.5);
  EXPECT_EQ(distance(5, 5, 8), -1);
  EXPECT_EQ(distance(0, 3, 10), 0);
}

/// 205^3 samples are more than fit into the memory that a grid is written through.
TEST_F(GridTest, ALargeGridGoesOnWhereASlabEnds) {
  const Outcome outcome =
      run({"grid", cube_, "--resolution", "205", "-o", path("a.npy"), "--json", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.json()["inside"], 203 * 203 * 203);
  const std::string npy = text_of("a.npy");
  constexpr std::size_t header = 128;
  ASSERT_EQ(npy.size(), header + std::size_t{205} * 205 * 205 * 8);
  for (std::size_t k = 0; k < 205; ++k) {
    const double from_end = 5 * static_cast<double>(std::min(k, 204 - k)) / 204;
    EXPECT_NEAR(number_at(npy, header + 8 * ((k * 205 + 102) * 205 + 102)), -from_end, 1e-12) << k;
  }
}

TEST_F(GridTest, VtiHoldsTheSameNumbers) {
  ASSERT_EQ(run({"grid", cube_, "--resolution", "6", "-o", path("a.npy")}).status, 0);
  ASSERT_EQ(run({"grid", cube_, "--resolution", "6", "-o", path("a.vti")}).status, 0);
  const std::string npy = text_of("a.npy"), vti = text_of("a.vti");
  EXPECT_NE(vti.find("WholeExtent=\"0 5 0 5 0 5\" Origin=\"0 0 0\" Spacing=\"1 1 1\""), std::string::npos)
      << vti;
  constexpr std::size_t bytes = 216 * 8;
  const std::size_t data = vti.find("\n_") + 2;
  std::uint64_t length = 0;
  ASSERT_GT(vti.size(), data + 8 + bytes);
  std::memcpy(&length, vti.data() + data, sizeof length);
  EXPECT_EQ(length, bytes);
  EXPECT_EQ(vti.substr(data + 8, bytes), npy.substr(npy.size() - bytes));
  EXPECT_EQ(vti.substr(data + 8 + bytes), "\n</AppendedData>\n</VTKFile>\n");
}

TEST_F(GridTest, JsonSaysWhereTheSamplesAre) {
  const Outcome outcome =
      run({"grid", cube_, "--resolution", "6", "-o", path("a.npy"), "--json", "--unit", "mm"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto report = outcome.json();
  EXPECT_EQ(report["schema"], 1);
  EXPECT_EQ(report["grid"]["size"], nlohmann::json({6, 6, 6}));
  EXPECT_EQ(report["samples"], 216);
  EXPECT_EQ(report["inside"], 64);
  EXPECT_EQ(report["distance"]["min"], -2);
}

TEST_F(GridTest, ASignalLeavesNothingBehind) {
  Program program = start({"grid", cube_, "--resolution", "400", "--threads", "1", "-o", path("a.npy")});
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  ASSERT_TRUE(program.running());
  program.send(SIGINT);
  EXPECT_EQ(program.wait().status, 130);
  EXPECT_TRUE(names_but({"cube.stl"}).empty());
}

}  // namespace
}  // namespace cdfr
