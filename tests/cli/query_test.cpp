/// query: known distances of a cube with an edge of 5, the same numbers in each format.
#include <cstring>
#include <sstream>

#include "cli/program.h"

namespace cdfr {
namespace {

class QueryTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    cube_ = part("cube", "cube.stl");
    put("points.csv", "x,y,z\n2.5,2.5,1\n2.5,2.5,7\n8,9,2.5\n-2,-1,-2\n2.5,0,2.5\n1000,2.5,2.5\n");
  }
  std::string cube_;
};

constexpr double expected[] = {-1, 2, 5, 3, 0, 995};

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

template <class T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value{};
  if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

TEST_F(QueryTest, CsvHasTheKnownDistancesAndFeatures) {
  const Outcome outcome = run({"query", cube_, "--points", path("points.csv"), "-o", path("a.csv")});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto rows = rows_of(text_of("a.csv"));
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(text_of("a.csv").substr(0, 50), "distance,cx,cy,cz,gx,gy,gz,triangle,feature\n-1,2.5");
  for (std::size_t i = 0; i < 6; ++i) {
    ASSERT_EQ(rows[i + 1].size(), 9U);
    EXPECT_DOUBLE_EQ(std::stod(rows[i + 1][0]), expected[i]);
    EXPECT_LT(std::stoul(rows[i + 1][7]), 12U);
  }
  EXPECT_EQ(rows[3][8], "edge");
  EXPECT_EQ(rows[4][8], "vertex");
  EXPECT_EQ(std::stod(rows[1][6]), -1) << "the gradient points out of the part, through the nearest face";
}

TEST_F(QueryTest, StandardStreamsCarryTheSameTable) {
  ASSERT_EQ(run({"query", cube_, "--points", path("points.csv"), "-o", path("a.csv")}).status, 0);
  for (const std::vector<std::string>& end : {std::vector<std::string>{}, {"-o", "-"}}) {
    std::vector<std::string> arguments{"query", cube_, "--points", "-"};
    arguments.insert(arguments.end(), end.begin(), end.end());
    const Outcome outcome = run(arguments, text_of("points.csv"));
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, text_of("a.csv"));
    EXPECT_EQ(outcome.errors, "");
  }
}

TEST_F(QueryTest, NpyAndPlyHoldTheSameDistances) {
  ASSERT_EQ(run({"query", cube_, "--points", path("points.csv"), "-o", path("a.npy")}).status, 0);
  ASSERT_EQ(run({"query", cube_, "--points", path("points.csv"), "-o", path("a.ply")}).status, 0);
  const std::string npy = text_of("a.npy"), ply = text_of("a.ply");
  const std::size_t header = 10 + value_at<std::uint16_t>(npy, 8);
  EXPECT_EQ(header % 64, 0U);
  ASSERT_EQ(npy.size(), header + 6 * 9 * 8);
  EXPECT_NE(npy.find("'shape': (6, 9)"), std::string::npos);
  const std::string last = "end_header\n";
  const std::size_t body = ply.find(last) + last.size();
  constexpr std::size_t row = 10 * 8 + 4 + 1;
  ASSERT_EQ(ply.size(), body + 6 * row);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_DOUBLE_EQ(value_at<double>(npy, header + 72 * i), expected[i]);
    EXPECT_DOUBLE_EQ(value_at<double>(ply, body + row * i + 24), expected[i]);
  }
  EXPECT_EQ(value_at<double>(npy, header + 72 * 3 + 64), 2) << "vertex";
}

TEST_F(QueryTest, AnswersArePointsAgain) {
  ASSERT_EQ(run({"query", cube_, "--points", path("points.csv"), "-o", path("a.ply")}).status, 0);
  ASSERT_EQ(run({"query", cube_, "--points", path("a.ply"), "-o", path("b.ply")}).status, 0);
  EXPECT_EQ(text_of("a.ply"), text_of("b.ply"));
}

TEST_F(QueryTest, NoPointsGiveAnEmptyTable) {
  const Outcome outcome = run({"query", cube_, "--points", "-", "-o", path("a.csv"), "--json"}, "x,y,z\n");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(text_of("a.csv"), "distance,cx,cy,cz,gx,gy,gz,triangle,feature\n");
  EXPECT_EQ(outcome.json()["points"], 0);
}

TEST_F(QueryTest, JsonSummaryCountsWhatIsInside) {
  const Outcome outcome =
      run({"query", cube_, "--points", path("points.csv"), "-o", path("a.csv"), "--json", "--unit", "mm"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto report = outcome.json();
  EXPECT_EQ(report["schema"], 1);
  EXPECT_EQ(report["unit"], "mm");
  EXPECT_EQ(report["points"], 6);
  EXPECT_EQ(report["inside"], 1);
  EXPECT_EQ(report["distance"]["max"], 995);
}

/// More points than a block, so that blocks join in order.
TEST_F(QueryTest, ManyBlocksKeepTheOrder) {
  std::string points;
  constexpr int count = 70000;
  for (int i = 0; i < count; ++i) points += "2.5,2.5," + std::to_string(5 + i) + "\n";
  const Outcome outcome = run({"query", cube_, "--points", "-"}, points);
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto rows = rows_of(outcome.output);
  ASSERT_EQ(rows.size(), count + 1U);
  for (const int i : {0, 65535, 65536, count - 1}) {
    EXPECT_EQ(rows[static_cast<std::size_t>(i) + 1][0], std::to_string(i));
  }
}

}  // namespace
}  // namespace cdfr
