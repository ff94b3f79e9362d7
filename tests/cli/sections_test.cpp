/// sections: what is thicker than asked, in each form, and what it is compared with.
#include <algorithm>

#include "cli/program.h"

namespace cdfr {
namespace {

class SectionsCliTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    cube_ = part("cube", "cube.stl");
  }
  std::string cube_;  ///< of edge 5
};

TEST_F(SectionsCliTest, JsonHasBallVolumeAndBox) {
  const Outcome outcome =
      run({"sections", cube_, "--depth", "1", "--unit", "mm", "--density", "2", "--error", "0.02", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto report = outcome.json();
  EXPECT_EQ(report["schema"], 1);
  EXPECT_EQ(report["unit"], "mm");
  EXPECT_EQ(report["depth"], 1);
  EXPECT_EQ(report["thicker_than"], 2);
  EXPECT_DOUBLE_EQ(report["mass"].get<double>(), 250);
  ASSERT_EQ(report["sections"].size(), 1U);
  const auto& section = report["sections"][0];
  EXPECT_EQ(section["rank"], 1);
  EXPECT_NEAR(section["ball"]["radius"].get<double>(), 2.5, 0.02);
  EXPECT_NEAR(section["ball"]["center"][2].get<double>(), 2.5, 0.02);
  EXPECT_EQ(section["ball"]["touches"].size(), report["audit"]["triangles"]);
  EXPECT_NEAR(section["volume"].get<double>(), 27, section["volume_error"].get<double>());
  EXPECT_NEAR(section["box"]["max"][0].get<double>(), 4, 0.04);
  EXPECT_EQ(section["triangles"].size(), report["audit"]["triangles"]);
  EXPECT_TRUE(report["may_join"].empty());
  EXPECT_TRUE(report["against"].is_null());
  EXPECT_EQ(report["provenance"]["sha256"].get<std::string>().size(), 64U);
}

TEST_F(SectionsCliTest, ThickerThanIsTwiceTheDepthAndBothAreSaid) {
  const Outcome depth = run({"sections", cube_, "--depth", "2", "-o", path("a.csv")});
  const Outcome thick = run({"sections", cube_, "--thicker-than", "4", "-o", path("b.csv")});
  ASSERT_EQ(depth.status, 0) << depth.errors;
  ASSERT_EQ(thick.status, 0) << thick.errors;
  EXPECT_EQ(text_of("a.csv"), text_of("b.csv"));
  EXPECT_NE(thick.output.find("thicker than 4 (depth 2)"), std::string::npos) << thick.output;
  EXPECT_NE(thick.output.find("+-"), std::string::npos) << thick.output;
}

TEST_F(SectionsCliTest, EveryFormIsWritten) {
  for (const char* file : {"s.json", "s.csv", "s.glb", "s.ply", "s.vtp"}) {
    const Outcome outcome = run({"sections", cube_, "--depth", "1", "-o", path(file), "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_GT(text_of(file).size(), 100U) << file;
  }
  const std::string csv = text_of("s.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2);
  EXPECT_EQ(nlohmann::json::parse(text_of("s.json"))["sections"].size(), 1U);
}

TEST_F(SectionsCliTest, ModulusIsInEachFormWhereAskedFor) {
  const std::vector<std::string> ask{"sections", cube_, "--depth", "1", "--unit", "mm"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), ask.begin(), ask.end());
    return run(more);
  };
  const auto none = with({"--json", "-o", path("none.csv")}).json();
  EXPECT_TRUE(none["sections"][0]["modulus"].is_null());
  EXPECT_NE(text_of("none.csv").find(",,\n"), std::string::npos);
  const auto modulus = with({"--modulus", "--json", "-o", path("m.csv")}).json()["sections"][0]["modulus"];
  EXPECT_NEAR(modulus["value"].get<double>(), 5.0 / 6, 1e-6);
  EXPECT_EQ(modulus["cooling_area"], 150);
  EXPECT_NE(text_of("m.csv").find(",modulus,modulus_error\n"), std::string::npos);
  EXPECT_EQ(text_of("m.csv").find(",,\n"), std::string::npos);
  const Outcome text = with({"--modulus"});
  EXPECT_NE(text.output.find("modulus 0.83333"), std::string::npos) << text.output;
  const auto cold = with({"--modulus", "--not-cooling", "0", "--json"}).json();
  EXPECT_TRUE(cold["sections"][0]["modulus"]["value"].is_null());
  EXPECT_EQ(cold["not_cooling"][0], "0");
  EXPECT_NE(with({"--modulus", "--not-cooling", "0"}).output.find("infinite"), std::string::npos);
  EXPECT_EQ(with({"--not-cooling", "0"}).status, 2);
  EXPECT_EQ(with({"--modulus", "--not-cooling", "riser"}).status, 2);
  EXPECT_EQ(run({"sections", cube_, "--modulus"}).status, 2);
  EXPECT_EQ(run({"sections", cube_, "--not-cooling", "0"}).status, 2);
}

TEST_F(SectionsCliTest, NoneIsAnAnswer) {
  const Outcome outcome = run({"sections", cube_, "--thicker-than", "5"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("none"), std::string::npos) << outcome.output;
  EXPECT_TRUE(run({"sections", cube_, "--depth", "2.5", "--json"}).json()["sections"].empty());
  EXPECT_EQ(run({"sections", cube_, "--depth", "1", "--min-depth", "3", "--json"}).json()["left_out"], 1);
  EXPECT_EQ(run({"sections", cube_, "--depth", "1", "--min-volume", "30", "--json"}).json()["left_out"], 1);
}

TEST_F(SectionsCliTest, AgainstTellsWhatChanged) {
  ASSERT_EQ(run({"build", cube_, "-o", path("cube.cdfr")}).status, 0);
  const auto fate = [&](const std::string& now, const std::string& former) {
    const Outcome outcome = run({"sections", now, "--depth", "0.5", "--against", former, "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    const auto changes = outcome.json()["against"]["changes"];
    EXPECT_EQ(changes.size(), 1U);
    return changes[0]["fate"].get<std::string>();
  };
  EXPECT_EQ(fate(cube_, path("cube.cdfr")), "same");
  const Outcome text = run({"sections", cube_, "--depth", "1", "--against", path("cube.cdfr")});
  EXPECT_NE(text.output.find("same: was"), std::string::npos) << text.output;
}

TEST_F(SectionsCliTest, WrongUsageAndWhatHasNoInside) {
  EXPECT_EQ(run({"sections"}).status, 2);
  EXPECT_EQ(run({"sections", cube_, "--depth", "1", "--thicker-than", "2"}).status, 2);
  EXPECT_EQ(run({"sections", cube_, "--depth", "-1"}).status, 2);
  EXPECT_EQ(run({"sections", cube_, "--depth", "1", "--error", "1e-9"}).status, 2);
  EXPECT_EQ(run({"sections", cube_, "--depth", "1", "-o", path("s.png")}).status, 2);
  EXPECT_EQ(run({"sections", cube_, "--depth", "1", "--part", cube_}).status, 2);
  const Outcome outcome = run({"sections", cube_, "--sign", "none", "--depth", "1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.one_error_line()) << outcome.errors;
}

}  // namespace
}  // namespace cdfr
