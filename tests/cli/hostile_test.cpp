/// Bad input ends in one line that says what and where, never in a crash or a wrong answer.
#include <algorithm>

#include "cli/program.h"

namespace cdfr {
namespace {

using HostileTest = CliTest;

std::vector<std::filesystem::path> dirty_models() {
  std::vector<std::filesystem::path> found;
  std::error_code missing;
  const auto folder = std::filesystem::path(CDFR_SHARED_DATA) / "public" / "dirty_pub";
  for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
    found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST_F(HostileTest, EachDirtyModelIsReadOrRefusedInOneLine) {
  const auto models = dirty_models();
  if (models.empty()) GTEST_SKIP() << "no models at " << CDFR_SHARED_DATA << "/public/dirty_pub";
  int refused = 0;
  for (const auto& model : models) {
    for (const std::string verb : {"audit", "info"}) {
      SCOPED_TRACE(verb + " " + model.filename().string());
      const Outcome outcome = run({verb, model.string(), "--json", "--quiet"});
      if (outcome.status == 0) {
        EXPECT_EQ(outcome.errors, "");
        EXPECT_GT(outcome.json()["triangles"], 0);
        continue;
      }
      ++refused;
      EXPECT_EQ(outcome.status, 1);
      EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
      EXPECT_NE(outcome.errors.find(model.filename().string()), std::string::npos) << outcome.errors;
      EXPECT_EQ(outcome.output, "");
    }
  }
  EXPECT_GT(refused, 0);
}

TEST_F(HostileTest, WhatIsNoFileIsRefused) {
  for (const std::string& input : {path("missing.stl"), folder().string(), path("missing.cdfr"),
                                   std::string("/dev/null"), path("no/such/folder.obj"), std::string()}) {
    for (const std::string verb : {"audit", "info"}) {
      SCOPED_TRACE(verb + " '" + input + "'");
      const Outcome outcome = run({verb, input});
      EXPECT_EQ(outcome.status, 1);
      EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
    }
  }
}

TEST_F(HostileTest, EveryTruncationOfASavedFieldIsRefused) {
  ASSERT_EQ(run({"build", part("cube", "cube.stl"), "-o", path("cube.cdfr")}).status, 0);
  const std::string whole = text_of("cube.cdfr");
  ASSERT_GT(whole.size(), 100U);
  for (std::size_t part_of = 0; part_of < 24; ++part_of) {
    const std::size_t kept = whole.size() * part_of / 24;
    put("short.cdfr", whole.substr(0, kept));
    SCOPED_TRACE(kept);
    const Outcome outcome = run({"info", path("short.cdfr")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
  }
}

TEST_F(HostileTest, NamesDoNotSteerTheTerminal) {
  const Outcome missing = run({"audit", path("\x1b]0;owned\x07\n\xff\xe2\x80\xae.stl")});
  EXPECT_EQ(missing.status, 1);
  EXPECT_TRUE(missing.one_error_line()) << missing.errors;
  EXPECT_NE(missing.errors.find("\\x1b]0;owned\\x07\\x0a\\xff\\u202e.stl"), std::string::npos)
      << missing.errors;
  put("named.obj",
      "o \x1b[2Jclear\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const Outcome patches = run({"audit", path("named.obj")});
  EXPECT_EQ(patches.status, 0) << patches.errors;
  EXPECT_EQ(patches.output.find('\x1b'), std::string::npos);
  EXPECT_NE(patches.output.find("\\x1b[2Jclear"), std::string::npos) << patches.output;
  EXPECT_EQ(run({"audit", path("named.obj"), "--json"}).json()["patches"][0], "\x1b[2Jclear");
}

TEST_F(HostileTest, BadPointsAreRefusedByLine) {
  const std::string cube = part("cube", "cube.stl");
  const Outcome outcome = run({"query", cube, "--points", "-"}, "x,y,z\n1,2,3\n1,2,much\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
  EXPECT_NE(outcome.errors.find("standard input"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("line 3"), std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
}

}  // namespace
}  // namespace cdfr
