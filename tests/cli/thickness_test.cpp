/// thickness: tables, JSON, reports, refusals, and revisions compared.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "cdfr/export/write.h"
#include "cli/program.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

class ThicknessCliTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    plate_ = made("plate.ply", {{0, 0, 0}, {12, 10, 2}});
  }
  std::string made(const std::string& name, const Box& box) const {
    write_mesh(test::box_mesh(box).view(), path(name)).value();
    return path(name);
  }
  std::string plate_;
};

TEST_F(ThicknessCliTest, JsonHasWhatWasAskedAndFound) {
  const Outcome outcome =
      run({"thickness", plate_, "--json", "--unit", "mm", "--density", "2", "--facet", "0", "--bins", "5"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto report = outcome.json();
  for (const char* key :
       {"provenance", "audit",    "method",    "at",        "facet", "sharp",   "edges",
        "error",      "rounding", "largest",   "samples",   "unmet", "at_edge", "regions",
        "queries",    "area",     "thickness", "histogram", "thin",  "places",  "seconds"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  EXPECT_EQ(report["schema"], 1);
  EXPECT_EQ(report["unit"], "mm");
  EXPECT_EQ(report["samples"], 12);
  EXPECT_NEAR(report["thickness"]["max"].get<double>(), 2, 1e-6);
  EXPECT_EQ(report["histogram"]["area"].size(), 5U);
  EXPECT_NEAR(report["volume"].get<double>(), 240, 1e-9);
  EXPECT_NEAR(report["mass"].get<double>(), 480, 1e-9);
  EXPECT_TRUE(report["against"].is_null());
  ASSERT_FALSE(report["places"].empty());
  EXPECT_EQ(report["places"][0]["rank"], 1);
  EXPECT_TRUE(report["places"][0]["opposed"]);
  EXPECT_NEAR(report["places"][0]["thickness"].get<double>(), 2, 1e-6);
}

TEST_F(ThicknessCliTest, TextHasTolerancesBesideItsNumbers) {
  const Outcome outcome = run({"thickness", plate_, "--unit", "mm", "--error", "0.01"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("mm +- 0.01"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("none: no triangle is curved"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("volume"), std::string::npos);
}

TEST_F(ThicknessCliTest, TablesHaveTheSameColumns) {
  for (const char* name : {"w.csv", "w.npy", "w.ply"}) {
    const Outcome outcome = run({"thickness", plate_, "--at", "vertices", "-o", path(name), "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
  }
  std::istringstream csv(text_of("w.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(
      line,
      "x,y,z,nx,ny,nz,thickness,error,ox,oy,oz,triangle,opposite,patch,opposite_patch,area,at_edge,facet,"
      "opposed");
  std::size_t rows = 0;
  for (; std::getline(csv, line); ++rows) EXPECT_EQ(std::ranges::count(line, ','), 18);
  EXPECT_EQ(rows, 8U);
  EXPECT_NE(text_of("w.npy").find("(8, 19)"), std::string::npos);
  const std::string ply = text_of("w.ply");
  EXPECT_NE(ply.find("element vertex 8\n"), std::string::npos);
  const std::size_t row = 11 * 8 + 4 * 4 + 8 + 1 + 8 + 1;
  EXPECT_EQ(ply.size(), ply.find("end_header\n") + 11 + 8 * row);
}

TEST_F(ThicknessCliTest, PaintsThePart) {
  for (const char* name : {"w.glb", "w.vtp"}) {
    for (const std::vector<std::string>& where :
         {std::vector<std::string>{"--at", "vertices"}, {"--spacing", "0.5", "--edges", "skip"}}) {
      std::vector<std::string> words{"thickness", plate_, "-o", path(name), "--quiet"};
      words.insert(words.end(), where.begin(), where.end());
      const Outcome outcome = run(words);
      ASSERT_EQ(outcome.status, 0) << outcome.errors;
      EXPECT_NE(text_of(name).find("thickness"), std::string::npos);
      EXPECT_EQ(text_of(name).find("sha256") == std::string::npos, name == std::string("w.vtp"))
          << "where notes are numbers";
    }
  }
}

TEST_F(ThicknessCliTest, TakesASavedFieldAndAPartToPaint) {
  ASSERT_EQ(run({"build", plate_, "-o", path("plate.cdfr"), "--quiet"}).status, 0);
  const auto from_field = run({"thickness", path("plate.cdfr"), "--json"}).json();
  const auto from_mesh = run({"thickness", plate_, "--json"}).json();
  EXPECT_EQ(from_field["thickness"], from_mesh["thickness"]);
  EXPECT_EQ(from_field["places"], from_mesh["places"]);
  EXPECT_EQ(run({"thickness", path("plate.cdfr"), "-o", path("w.glb")}).status, 2);
  EXPECT_FALSE(exists("w.glb"));
  const Outcome painted =
      run({"thickness", path("plate.cdfr"), "-o", path("w.glb"), "--part", plate_, "--quiet"});
  EXPECT_EQ(painted.status, 0) << painted.errors;
  write_mesh(test::icosphere(1).view(), path("other.ply")).value();
  EXPECT_EQ(run({"thickness", path("plate.cdfr"), "-o", path("v.glb"), "--part", path("other.ply")}).status,
            1);
  EXPECT_FALSE(exists("v.glb"));
}

TEST_F(ThicknessCliTest, ListsWallsThatThinned) {
  const std::string thinner = made("thinner.ply", {{0, 0, 0}, {12, 10, 1.75}});
  const Outcome outcome =
      run({"thickness", thinner, "--against", plate_, "--reach", "0.5", "--spacing", "0.5", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto against = outcome.json()["against"];
  EXPECT_EQ(against["former"], plate_);
  ASSERT_FALSE(against["places"].empty());
  EXPECT_NEAR(against["places"][0]["former"].get<double>(), 2, 1e-6);
  EXPECT_NEAR(against["places"][0]["thickness"].get<double>(), 1.75, 1e-6);
  const auto text = run({"thickness", thinner, "--against", plate_, "--reach", "0.5", "--spacing", "0.5"});
  EXPECT_NE(text.output.find("thinned"), std::string::npos);
  EXPECT_TRUE(run({"thickness", plate_, "--against", plate_, "--json"}).json()["against"]["places"].empty());
}

TEST_F(ThicknessCliTest, RefusesByName) {
  const std::vector<std::vector<std::string>> wrong{
      {"--cone", "10"},
      {"--method", "ray", "--cone", "10"},
      {"--method", "ray", "--facet", "0.1"},
      {"--at", "vertices", "--spacing", "1"},
      {"--method", "guess"},
      {"--edges", "none"},
      {"--sharp", "0"},
      {"--sharp", "nan"},
      {"--error", "0"},
      {"--reach", "1"},
      {"--change", "1"},
      {"--part", plate_},
      {"-o", path("w.txt")},
      {"--error", "1e-300"},
      {"--spacing", "1e-200"},
  };
  for (const auto& words : wrong) {
    std::vector<std::string> all{"thickness", plate_};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.status, 2) << words[0] << ' ' << words[1] << outcome.errors;
    EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
  }
  const Outcome unsigned_field = run({"thickness", plate_, "--sign", "none"});
  EXPECT_EQ(unsigned_field.status, 1);
  EXPECT_TRUE(unsigned_field.one_error_line());
  EXPECT_EQ(run({"thickness", plate_, "--against", path("missing.stl")}).status, 1);
}

}  // namespace
}  // namespace cdfr
