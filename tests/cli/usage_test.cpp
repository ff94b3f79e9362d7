/// Wrong usage has status 2, one line, and is found before any work.
#include "cli/program.h"

namespace cdfr {
namespace {

using UsageTest = CliTest;

TEST_F(UsageTest, WrongUsageIsStatusTwoAndOneLine) {
  const std::string cube = part("cube", "cube.stl");
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"measure"},
      {"audit"},
      {"audit", cube, "again"},
      {"audit", cube, "--distances"},
      {"info", cube, "--max-level", "19"},
      {"info", cube, "--max-level", "-1"},
      {"info", cube, "--max-level", "six"},
      {"info", cube, "--max-level", "6.5"},
      {"info", cube, "--max-level", "0x6"},
      {"info", cube, "--max-triangles", "0"},
      {"info", cube, "--max-triangles", "99999999999999999999"},
      {"info", cube, "--margin", "-0.1"},
      {"info", cube, "--margin", "nan"},
      {"info", cube, "--gain", "0"},
      {"info", cube, "--lists", "edge"},
      {"info", cube, "--sign", "parity"},
      {"info", cube, "--threads", "-2"},
      {"info", cube, "--unit", "m\x1b[31mm"},
      {"build", cube},
      {"build", cube, "-o", path("cube.field")},
      {"build", cube, "-o", path("cube")},
      {"contour", cube, "-o", path("c.ply")},
      {"contour", cube, "--distance", "1", "--depth", "1", "-o", path("c.ply")},
      {"contour", cube, "--distance", "inf", "-o", path("c.ply")},
      {"contour", cube, "--depth", "1"},
      {"contour", cube, "--depth", "1", "-o", path("c.txt")},
      {"contour", cube, "--depth", "1", "-o", path("c.ply"), "--picture", path("c.jpg")},
      {"contour", cube, "--depth", "1", "-o", path("c.ply"), "--tolerance", "0"},
      {"contour", cube, "--depth", "1", "-o", path("c.ply"), "--part", cube},
      {"contour", cube, "--depth", "1", "-o", path("c.ply"), "--mesh", "--rule", "paper"},
      {"contour", cube, "--depth", "1", "-o", path("c.ply"), "--rule", "loose"},
      {"info", cube, "--level", "19"},
      {"query", cube},
      {"query", cube, "--points", path("p.csv"), "-o", path("a.xlsx")},
      {"query", cube, "--points", path("p.csv"), "--json"},
      {"grid", cube, "--resolution", "8"},
      {"grid", cube, "--resolution", "1", "-o", path("a.npy")},
      {"grid", cube, "--resolution", "8", "-o", path("a.csv")},
      {"make-part", "cube"},
      {"make-part", "sprocket", "-o", path("s.stl")},
      {"make-part", "cube", "-o", path("cube.step")},
      {"make-part", "cube", "-o", path("cubes.stl"), "--copies", "0"},
      {"make-part", "cube", "-o", path("cubes.stl"), "--copies", "1e3"},
      {"make-part", "cube", "-o", path("cubes.stl"), "--copies", "1000000000"},
  };
  for (const auto& arguments : wrong) {
    std::string said;
    for (const std::string& word : arguments) said += word + " ";
    SCOPED_TRACE(said);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(outcome.errors.find('\x1b'), std::string::npos);
  }
  EXPECT_EQ(names_but({"cube.stl"}), std::vector<std::string>());
}

TEST_F(UsageTest, BuildOptionsOfASavedFieldAreRefusedNotIgnored) {
  const std::string cube = part("cube", "cube.stl");
  ASSERT_EQ(run({"build", cube, "-o", path("cube.cdfr")}).status, 0);
  const Outcome outcome = run({"info", path("cube.cdfr"), "--max-level", "3"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.errors.find("--max-level"), std::string::npos) << outcome.errors;
}

TEST_F(UsageTest, HelpAndVersion) {
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.errors, "");
  for (const std::string verb : {"audit", "build", "info", "query", "grid", "contour", "make-part"}) {
    EXPECT_NE(help.output.find("cdfr " + verb + " "), std::string::npos) << "no example of " << verb;
    const Outcome own = run({verb, "--help"});
    EXPECT_EQ(own.status, 0);
    EXPECT_NE(own.output.find("cdfr " + verb + " "), std::string::npos) << "no example of " << verb;
  }
  EXPECT_EQ(run({"--version"}).output.rfind("cdfr ", 0), 0U);
}

TEST_F(UsageTest, AFileMayBeNamedLikeAVerb) {
  part("cube", "cube.stl");
  std::filesystem::rename(folder() / "cube.stl", folder() / "build");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder());
  const Outcome outcome = run({"audit", "build", "--json"});
  std::filesystem::current_path(before);
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.json()["triangles"], 12);
}

}  // namespace
}  // namespace cdfr
