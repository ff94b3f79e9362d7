/// contour: what was found and where, and answers that are refusals or emptiness by name.
#include <algorithm>

#include "cli/program.h"

namespace cdfr {
namespace {

class ContourCliTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    cube_ = part("cube", "cube.stl");
  }
  std::string cube_;
};

TEST_F(ContourCliTest, JsonHasTheCountsAndTheBox) {
  const Outcome outcome = run({"contour", cube_, "--depth", "1", "--tolerance", "0.2", "-o", path("c.csv"),
                               "--json", "--unit", "mm"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto report = outcome.json();
  for (const char* key : {"leaves", "visited", "productive", "evaluations", "points", "undecided", "subvoxel",
                          "tolerance", "max_error", "box", "seconds"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  EXPECT_EQ(report["schema"], 1);
  EXPECT_EQ(report["distance"], -1);
  EXPECT_EQ(report["tolerance"], 0.2);
  ASSERT_GT(report["points"], 0);
  for (const std::size_t axis : {0U, 1U, 2U}) {
    EXPECT_NEAR(report["box"]["min"][axis].get<double>(), 1, 0.2);
    EXPECT_NEAR(report["box"]["max"][axis].get<double>(), 4, 0.2);
  }
  const std::string csv = text_of("c.csv");
  EXPECT_EQ(static_cast<std::uint64_t>(std::count(csv.begin(), csv.end(), '\n')),
            report["points"].get<std::uint64_t>() + 1);
}

TEST_F(ContourCliTest, NegativeNumbersAreTakenAsValues) {
  const Outcome depth = run({"contour", cube_, "--depth", "1", "--tolerance", "0.5", "-o", path("a.csv")});
  const Outcome distance =
      run({"contour", cube_, "--distance", "-1", "--tolerance", "0.5", "-o", path("b.csv")});
  EXPECT_EQ(depth.status, 0) << depth.errors;
  EXPECT_EQ(distance.status, 0) << distance.errors;
  EXPECT_EQ(text_of("a.csv"), text_of("b.csv"));
}

TEST_F(ContourCliTest, NoPointIsAnAnswer) {
  const std::vector<std::string> arguments{"contour", cube_, "--depth", "3", "-o", path("c.csv")};
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("no point at this depth"), std::string::npos) << outcome.output;
  auto as_json = arguments;
  as_json.emplace_back("--json");
  const auto report = run(as_json).json();
  EXPECT_EQ(report["points"], 0);
  EXPECT_TRUE(report["box"].is_null());
  EXPECT_DOUBLE_EQ(report["tolerance"].get<double>(), 0.005) << "longest side / 1000";
}

TEST_F(ContourCliTest, DepthOfAnUnsignedFieldIsRefusedByName) {
  put("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_EQ(run({"build", path("open.obj"), "--sign", "none", "-o", path("open.cdfr")}).status, 0);
  for (const std::vector<std::string>& input : {std::vector<std::string>{path("open.obj"), "--sign", "none"},
                                                {path("open.cdfr")},
                                                {cube_, "--sign", "none"}}) {
    std::vector<std::string> arguments{"contour"};
    arguments.insert(arguments.end(), input.begin(), input.end());
    arguments.insert(arguments.end(), {"--depth", "0.1", "-o", path("c.csv")});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
    EXPECT_NE(outcome.errors.find("no inside"), std::string::npos) << outcome.errors;
    EXPECT_FALSE(exists("c.csv"));
  }
}

TEST_F(ContourCliTest, AContourBeyondTheDomainIsWhole) {
  ASSERT_EQ(run({"build", cube_, "-o", path("cube.cdfr")}).status, 0);
  for (const std::string& input : {cube_, path("cube.cdfr")}) {
    const Outcome outcome =
        run({"contour", input, "--distance", "2", "--tolerance", "0.5", "-o", path("c.csv"), "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NEAR(outcome.json()["box"]["min"][0].get<double>(), -2, 0.5);
    EXPECT_NEAR(outcome.json()["box"]["max"][2].get<double>(), 7, 0.5);
  }
}

TEST_F(ContourCliTest, PictureWithAndWithoutThePart) {
  ASSERT_EQ(run({"build", cube_, "-o", path("cube.cdfr")}).status, 0);
  const std::vector<std::string> common{"--depth", "1", "--tolerance", "0.5", "--picture"};
  const auto draw = [&](std::vector<std::string> arguments, const std::string& image) {
    arguments.insert(arguments.begin(), "contour");
    arguments.insert(arguments.end(), common.begin(), common.end());
    arguments.push_back(path(image));
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(text_of(image).substr(1, 3), "PNG");
  };
  draw({cube_}, "mesh.png");
  draw({path("cube.cdfr"), "--part", cube_}, "part.png");
  draw({path("cube.cdfr")}, "points.png");
  EXPECT_EQ(text_of("mesh.png"), text_of("part.png"));
  EXPECT_NE(text_of("mesh.png"), text_of("points.png"));
}

TEST_F(ContourCliTest, MeshIsWrittenAndReported) {
  for (const char* file : {"m.ply", "m.stl", "m.obj"}) {
    const std::vector<std::string> arguments{"contour", cube_,    "--distance", "-1",      "--tolerance",
                                             "0.05",    "--mesh", "-o",         path(file)};
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("triangles"), std::string::npos) << outcome.output;
    auto as_json = arguments;
    as_json.emplace_back("--json");
    const auto report = run(as_json).json();
    EXPECT_GT(report["triangles"], 8);
    EXPECT_EQ(report["loose"], 0);
    EXPECT_TRUE(report["places"].is_array());
    EXPECT_NEAR(report["box"]["min"][0].get<double>(), 1, 1e-9);
    const auto audit = run({"audit", path(file), "--json"}).json();
    EXPECT_EQ(audit["closed"], true) << file;
    EXPECT_NEAR(audit["volume"].get<double>(), 27, 1e-3) << file;
  }
}

TEST_F(ContourCliTest, MeshOfWhatHasNoneIsRefusedByName) {
  EXPECT_EQ(run({"contour", cube_, "--distance", "1", "--mesh", "-o", path("m.glb")}).status, 2);
  EXPECT_EQ(run({"contour", cube_, "--distance", "1", "--mesh", "--picture", path("m.png")}).status, 2);
  put("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome open = run({"contour", path("open.obj"), "--distance", "0.1", "--mesh", "-o", path("m.ply")});
  EXPECT_EQ(open.status, 1);
  EXPECT_NE(open.errors.find("--sign none"), std::string::npos) << open.errors;
  EXPECT_FALSE(exists("m.ply"));
  EXPECT_EQ(
      run({"contour", path("open.obj"), "--sign", "none", "--distance", "0.1", "--mesh", "-o", path("m.ply")})
          .status,
      0);
}

}  // namespace
}  // namespace cdfr
