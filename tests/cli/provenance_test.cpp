/// Where a report comes from, and numbers beside what they may be off.
#include <cstdio>
#include <sstream>
#include <string>

#include "cdfr/version.h"
#include "cli/program.h"

namespace cdfr {
namespace {

using ProvenanceTest = CliTest;

/// The hash is that of another program: sha256sum.
TEST_F(ProvenanceTest, NamesTheInputByItsBytesAndTheOptionsAsGiven) {
  put("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto report = run({"audit", path("one.obj"), "--unit", "mm", "--json", "--threads", "1"}).json();
  const auto& provenance = report["provenance"];
  EXPECT_EQ(provenance["input"], path("one.obj"));
  EXPECT_EQ(provenance["sha256"], "697b00ab13410c52a542d2e9c63711fcc04e9cbf6c0d3439a9b43cc812e6e713");
  EXPECT_EQ(provenance["version"], version());
  EXPECT_EQ(provenance["options"], (std::vector<std::string>{"--json", "--threads", "1", "--unit", "mm"}));
  EXPECT_EQ(provenance["unit"], "mm");
  EXPECT_EQ(provenance["sign"], report["sign"]);
  EXPECT_EQ(provenance["audit"], report["sign_text"]);
}

TEST_F(ProvenanceTest, TheHashIsOfAllPiecesOfALargeFile) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string comments = std::string((std::size_t{3} << 20) + 17, '#') + "\n";
  put("a.obj", text + comments + "#a\n");
  put("b.obj", text + comments + "#b\n");
  const auto hash = [&](const std::string& name) {
    return run({"audit", path(name), "--json"}).json()["provenance"]["sha256"].get<std::string>();
  };
  EXPECT_EQ(hash("a.obj").size(), 64U);
  EXPECT_NE(hash("a.obj"), hash("b.obj"));
}

/// A brick of the given sides, its corners at multiples of them.
std::string brick(double x, double y, double z) {
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < 8; ++i) {
    text << "v " << (i & 1 ? x : 0) << ' ' << (i & 2 ? y : 0) << ' ' << (i & 4 ? z : 0) << '\n';
  }
  for (const char* face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"})
    text << "f " << face << '\n';
  return text.str();
}

/// What people read contains what programs read, and is not much wider.
TEST_F(ProvenanceTest, AnErrorShownContainsTheErrorMeant) {
  for (const double size : {1.0, 7.3e-15, 1.31e-8, 0.0123, 47.11, 9.99e5, 3.3e9, 1.7e40}) {
    for (const double long_side : {1.0, 3.37}) {
      SCOPED_TRACE(size);
      put("brick.obj", brick(size, 1.1 * size, long_side * size));
      const auto deepest = run({"info", path("brick.obj"), "--deepest", "--json"}).json()["deepest"];
      const std::string text = run({"info", path("brick.obj"), "--deepest", "--unit", "mm"}).output;
      double value = 0, error = 0;
      const std::size_t start = text.find("deepest: ");
      ASSERT_NE(start, std::string::npos);
      ASSERT_EQ(std::sscanf(text.c_str() + start, "deepest: %lf mm +- %lf at", &value, &error), 2) << text;
      const double depth = deepest["depth"], meant = deepest["error"];
      EXPECT_LE(value - error, depth - meant * (1 - 1e-11)) << text.substr(start);
      EXPECT_GE(value + error, depth + meant * (1 - 1e-11)) << text.substr(start);
      EXPECT_LE(error, 1.5 * meant + 1e-8 * depth) << text.substr(start);
    }
  }
}

}  // namespace
}  // namespace cdfr
