/// A signal ends the program soon, with its own status and nothing half-written.
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <cmath>
#include <thread>

#include "cdfr/export/write.h"
#include "cli/program.h"

namespace cdfr {
namespace {

using namespace std::chrono_literals;

/// A rippled sheet: an octree of great depth over it takes far longer than this test waits.
Mesh rippled_sheet(int side) {
  Mesh mesh;
  for (int i = 0; i <= side; ++i) {
    for (int j = 0; j <= side; ++j) {
      mesh.vertices.push_back({double(i), double(j), 3.0 * ((i * i + j * 7) % 11)});
    }
  }
  const auto vertex = [side](int i, int j) { return static_cast<std::uint32_t>(i * (side + 1) + j); };
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
      mesh.triangles.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

class InterruptTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    ASSERT_TRUE(write_mesh(rippled_sheet(200).view(), path("sheet.ply")));
  }

  /// Sends the signal once `ready`, and a little later, and gives back how the program ended.
  template <class Ready>
  Outcome interrupted(const std::vector<std::string>& arguments, int signal, Ready ready) {
    Program program = start(arguments);
    while (program.running() && !ready()) std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(500ms);
    EXPECT_TRUE(program.running()) << "ended before the signal: " << program.wait().errors;
    const auto sent = std::chrono::steady_clock::now();
    program.send(signal);
    const Outcome outcome = program.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - sent, 20s);
    return outcome;
  }
  std::vector<std::string> endless_build() const {
    return {
        "build", path("sheet.ply"), "-o", path("sheet.cdfr"), "--max-level", "14",        "--max-triangles",
        "1",     "--gain",          "1",  "--lists",          "band",        "--threads", "2"};
  }
};

TEST_F(InterruptTest, ABuildEndsWithTheStatusOfItsSignalAndNoFile) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto working = [this] { return std::filesystem::exists(path("sheet.cdfr.work")); };
    const Outcome outcome = interrupted(endless_build(), signal, working);
    EXPECT_EQ(outcome.status, 128 + signal) << outcome.errors;
    EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
    // What is left is for the same command to go on with.
    EXPECT_EQ(names_but({"sheet.ply"}), std::vector<std::string>{"sheet.cdfr.work"});
    std::filesystem::remove_all(path("sheet.cdfr.work"));
  }
}

TEST_F(InterruptTest, AContourLeavesTheOldFileAndNoTemporaryOne) {
  put("c.ply", "precious");
  const auto writing = [this] { return names_but({"sheet.ply", "c.ply"}).size() == 1; };
  const Outcome outcome = interrupted({"contour", path("sheet.ply"), "--sign", "none", "--distance", "0.5",
                                       "--tolerance", "0.2", "-o", path("c.ply")},
                                      SIGINT, writing);
  EXPECT_EQ(outcome.status, 130) << outcome.errors;
  EXPECT_EQ(text_of("c.ply"), "precious");
  EXPECT_EQ(names_but({"sheet.ply", "c.ply"}), std::vector<std::string>());
}

}  // namespace
}  // namespace cdfr
