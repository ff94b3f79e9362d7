/// Outputs are refused before the work, and are whole or not there after it.
#include <unistd.h>

#include "cli/program.h"

namespace cdfr {
namespace {

using OutputTest = CliTest;

/// Were the output looked at after the input, the error would name the input, which does not exist.
TEST_F(OutputTest, MissingDirectoryIsRefusedBeforeTheInputIsRead) {
  const std::string input = path("missing.stl");
  const std::vector<std::vector<std::string>> calls{
      {"build", input, "-o", path("no/f.cdfr")},
      {"contour", input, "--depth", "1", "-o", path("no/c.ply")},
      {"contour", input, "--depth", "1", "-o", path("c.ply"), "--picture", path("no/c.png")},
      {"query", input, "--points", path("p.csv"), "-o", path("no/a.csv")},
      {"grid", input, "--resolution", "8", "-o", path("no/a.vti")},
      {"make-part", "cube", "-o", path("no/cube.stl")},
  };
  for (const auto& arguments : calls) {
    SCOPED_TRACE(arguments[0]);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
    EXPECT_NE(outcome.errors.find("/no/"), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.errors.find("directory"), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(names_but({}), std::vector<std::string>());
}

TEST_F(OutputTest, ATargetThatIsNoRegularFileIsLeftAlone) {
  std::filesystem::create_directory(folder() / "taken.cdfr");
  std::filesystem::create_symlink("/dev/null", folder() / "link.cdfr");
  for (const std::string target : {"taken.cdfr", "link.cdfr"}) {
    const Outcome outcome = run({"build", path("missing.stl"), "-o", path(target)});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.errors.find(target), std::string::npos) << outcome.errors;
  }
  EXPECT_TRUE(std::filesystem::is_directory(folder() / "taken.cdfr"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder() / "link.cdfr"));
}

TEST_F(OutputTest, AnUnwritableDirectoryIsRefused) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  std::filesystem::create_directory(folder() / "locked");
  std::filesystem::permissions(folder() / "locked", std::filesystem::perms::owner_read);
  const Outcome outcome = run({"make-part", "cube", "-o", path("locked/cube.stl")});
  std::filesystem::permissions(folder() / "locked", std::filesystem::perms::owner_all);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
}

TEST_F(OutputTest, AFailedRunLeavesTheOldFile) {
  put("old.cdfr", "precious");
  const Outcome outcome = run({"build", path("missing.stl"), "-o", path("old.cdfr")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(text_of("old.cdfr"), "precious");
  EXPECT_EQ(names_but({"old.cdfr"}), std::vector<std::string>());
}

TEST_F(OutputTest, PartsAreWrittenInEachFormatAndReadBack) {
  for (const std::string file : {"cube.stl", "cube.ply", "cube.obj", "CUBE.STL"}) {
    SCOPED_TRACE(file);
    const auto report = run({"audit", part("cube", file), "--json"}).json();
    EXPECT_EQ(report["triangles"], 12);
    EXPECT_EQ(report["closed"], true);
    EXPECT_DOUBLE_EQ(report["volume"], 125);
  }
}

TEST_F(OutputTest, QuietSaysNothing) {
  const std::string cube = part("cube", "cube.stl");
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"build", cube, "-o", path("cube.cdfr"), "--quiet"},
           {"contour", cube, "--depth", "1", "--tolerance", "0.5", "-o", path("c.csv"), "--quiet"},
           {"make-part", "cube", "-o", path("again.stl"), "--quiet"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.output + outcome.errors, "");
  }
}

}  // namespace
}  // namespace cdfr
