/// audit, build and info: the documented keys, and the same field however it was come by.
#include "cli/program.h"

namespace cdfr {
namespace {

using FieldTest = CliTest;
using nlohmann::json;

void expect_keys(const json& object, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) EXPECT_TRUE(object.contains(key)) << "no " << key << " in " << object;
}

TEST_F(FieldTest, AuditHasAllCounts) {
  const Outcome outcome = run({"audit", part("cube", "cube.stl"), "--json", "--unit", "mm"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  const json report = outcome.json();
  expect_keys(report,
              {"input", "vertices", "open_edges", "nonmanifold_edges", "flipped_edges", "unbalanced_edges",
               "nonmanifold_vertices", "degenerate_triangles", "duplicate_triangles", "touching_triangles",
               "components", "turned_shells", "embedded", "sign_text"});
  EXPECT_EQ(report["schema"], 1);
  EXPECT_EQ(report["unit"], "mm");
  EXPECT_EQ(report["vertices"], 8);
  EXPECT_EQ(report["closed"], true);
  EXPECT_EQ(report["sign"], "pseudonormal");
  EXPECT_EQ(report["box"]["max"], json::array({5, 5, 5}));
  EXPECT_TRUE(report["warnings"].empty());
}

TEST_F(FieldTest, AuditNamesTheSignAndWarns) {
  put("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto open = run({"audit", path("open.obj"), "--json"}).json();
  EXPECT_EQ(open["closed"], false);
  EXPECT_EQ(open["sign"], "winding");
  EXPECT_EQ(open["sign_text"], "3 open edges");
  EXPECT_EQ(open["open_edges"], 3);
  put("inward.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n");
  const auto inward = run({"audit", path("inward.obj"), "--json"}).json();
  EXPECT_EQ(inward["closed"], true);
  EXPECT_LT(inward["volume"], 0);
  EXPECT_EQ(inward["turned_shells"], 1);
  EXPECT_EQ(inward["warnings"].size(), 2U);
  EXPECT_NE(run({"audit", path("inward.obj")}).output.find("inward"), std::string::npos);
}

TEST_F(FieldTest, TheSignThatWasChosenIsToldWithItsReason) {
  put("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  const Outcome built = run({"build", path("open.obj"), "-o", path("open.cdfr"), "--json"});
  ASSERT_EQ(built.status, 0) << built.errors;
  EXPECT_EQ(built.errors, "note: sign by winding: 3 open edges\n");
  EXPECT_EQ(built.json()["sign"], "winding");
  EXPECT_EQ(built.json()["audit"]["open_edges"], 3);
  const json saved = run({"info", path("open.cdfr"), "--json", "--quiet"}).json();
  EXPECT_EQ(saved["audit"], built.json()["audit"]);
  EXPECT_EQ(run({"info", path("open.obj"), "--json", "--sign", "auto", "--quiet"}).errors, "");
  EXPECT_EQ(run({"info", path("open.obj"), "--json", "--sign", "winding"}).errors, "");
}

TEST_F(FieldTest, FlipTurnsAMeshThatIsInsideOut) {
  put("inward.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n");
  put("p.csv", "0.2,0.2,0.2\n");
  const auto inside = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"query", path("inward.obj"), "--points", path("p.csv"),
                                   "-o",    path("out.csv"),    "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words).json();
  };
  EXPECT_EQ(inside({})["inside"], 0);
  EXPECT_EQ(inside({})["sign"], "winding");
  EXPECT_EQ(inside({"--flip"})["inside"], 1);
  EXPECT_EQ(inside({"--flip"})["sign"], "pseudonormal");
}

TEST_F(FieldTest, RepairIsAskedForAndCounted) {
  // A tetrahedron whose last face has corners of its own, a little off.
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1.0001 0 0\nv 0 1 0.0001\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf "
      "5 6 7\n";
  put("cracked.obj", text);
  const Outcome outcome =
      run({"audit", path("cracked.obj"), "--weld", "0.001", "-o", path("welded.obj"), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const json report = outcome.json();
  EXPECT_EQ(report["closed"], false);
  EXPECT_EQ(report["weld"]["merged_vertices"], 2);
  EXPECT_EQ(report["weld"]["collapsed_triangles"], 0);
  EXPECT_EQ(report["weld"]["audit"]["embedded"], true);
  EXPECT_EQ(text_of("cracked.obj"), text);
  EXPECT_EQ(run({"audit", path("welded.obj"), "--json"}).json()["closed"], true);
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--weld", "0.001"},
                                               {"-o", path("x.obj")},
                                               {"--weld", "far", "-o", path("x.obj")}}) {
    std::vector<std::string> words{"audit", path("cracked.obj")};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run(words).status, 2);
  }
  EXPECT_EQ(run({"audit", path("cracked.obj"), "--weld", "-1", "-o", path("x.obj")}).status, 2);
  EXPECT_FALSE(exists("x.obj"));
}

TEST_F(FieldTest, InfoHasTheDocumentedKeys) {
  const Outcome outcome = run({"info", part("six-star", "star.ply"), "--json", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const json report = outcome.json();
  expect_keys(report, {"triangles", "vertices", "bytes", "unit"});
  EXPECT_EQ(report["schema"], 1);
  EXPECT_EQ(report["sign"], "pseudonormal");
  expect_keys(report["domain"], {"min", "max"});
  expect_keys(report["leaves"], {"inside", "surface", "outside"});
  expect_keys(report["list"], {"mean", "p95", "max"});
  ASSERT_FALSE(report["levels"].empty());
  std::uint64_t leaves = 0;
  for (const json& level : report["levels"]) {
    expect_keys(level, {"level", "cells", "leaves", "mean_list"});
    leaves += level["leaves"].get<std::uint64_t>();
    EXPECT_EQ(level["entries_in"].get<std::uint64_t>(),
              level["entries_pruned"].get<std::uint64_t>() + level["entries_kept"].get<std::uint64_t>());
  }
  const json& sides = report["leaves"];
  EXPECT_EQ(leaves, sides["inside"].get<std::uint64_t>() + sides["surface"].get<std::uint64_t>() +
                        sides["outside"].get<std::uint64_t>());
  EXPECT_EQ(report["checksum"].get<std::string>().size(), 16U);
}

TEST_F(FieldTest, InfoShowsATableOfLevels) {
  const Outcome outcome = run({"info", part("six-star", "star.ply")});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  for (const char* column : {"level", "cells", "entries in", "pruned", "kept", "checksum"}) {
    EXPECT_NE(outcome.output.find(column), std::string::npos) << column;
  }
}

TEST_F(FieldTest, ASavedFieldIsTheBuiltOneOnAnyNumberOfThreads) {
  const std::string star = part("six-star", "star.ply");
  const Outcome built =
      run({"build", star, "-o", path("star.cdfr"), "--unit", "mm", "--threads", "1", "--json"});
  ASSERT_EQ(built.status, 0) << built.errors;
  EXPECT_EQ(built.json()["output"], path("star.cdfr"));
  const json loaded = run({"info", path("star.cdfr"), "--json"}).json();
  const json again = run({"info", star, "--json", "--threads", "3"}).json();
  EXPECT_EQ(loaded["unit"], "mm");
  EXPECT_EQ(loaded["checksum"], built.json()["checksum"]);
  EXPECT_EQ(loaded["checksum"], again["checksum"]);
  EXPECT_EQ(names_but({"star.ply", "star.cdfr"}), std::vector<std::string>());
  std::filesystem::rename(folder() / "star.cdfr", folder() / "star.bin");
  EXPECT_EQ(run({"info", path("star.bin"), "--json"}).json()["checksum"], loaded["checksum"]) << "by content";
}

TEST_F(FieldTest, AMeshIsNoFieldForBuildAndAudit) {
  ASSERT_EQ(run({"build", part("cube", "cube.stl"), "-o", path("cube.cdfr")}).status, 0);
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"audit", path("cube.cdfr")}, {"build", path("cube.cdfr"), "-o", path("again.cdfr")}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.errors.find("saved field"), std::string::npos) << outcome.errors;
  }
}

TEST_F(FieldTest, QueriesChooseTheListsAndChangeNoAnswer) {
  const std::string head = part("six-star", "star.stl");
  put("p.csv", "x,y,z\n1,2,3\n0.5,0,1\n-7,4,2\n");
  const auto answers = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"query", head, "--points", path("p.csv"), "-o", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments).output;
  };
  EXPECT_EQ(answers({"--queries", "1"}), answers({}));
  const json built =
      run({"build", head, "-o", path("few.cdfr"), "--queries", "1", "--json", "--quiet"}).json();
  EXPECT_GE(built["options"]["max_triangles"].get<int>() * 2, built["triangles"].get<int>());
  EXPECT_EQ(run({"build", head, "-o", path("x.cdfr"), "--queries", "0"}).status, 2);
  EXPECT_EQ(run({"build", head, "-o", path("x.cdfr"), "--queries", "9", "--max-triangles", "8"}).status, 2);
}

TEST_F(FieldTest, MemoryPackingAndDomainsChangeNoAnswer) {
  const std::string mesh = part("six-star", "star.stl");
  put("p.csv", "0.1,0.2,0.3\n0.5,1.5,1.5\n4,5,6\n");
  const auto answers = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"build", mesh, "-o", path("f.cdfr"), "--quiet"};
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_EQ(run(words).status, 0);
    EXPECT_EQ(run({"info", path("f.cdfr"), "--verify", "--json"}).json()["verified"], true);
    EXPECT_EQ(
        run({"query", path("f.cdfr"), "--points", path("p.csv"), "-o", path("o.csv"), "--quiet"}).status, 0);
    return text_of(path("o.csv"));
  };
  const std::string expected = answers({});
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--memory", "1GiB"},
                                             {"--compress"},
                                             {"--fresh"},
                                             {"--domain", "interior"},
                                             {"--domain", "band:0.2"}}) {
    EXPECT_EQ(answers(options), expected) << options.front();
  }
  EXPECT_EQ(run({"build", mesh, "-o", path("f.cdfr"), "--domain", "interior", "--json"})
                .json()["leaves"]["outside"],
            0);
  const Outcome tight = run({"build", mesh, "-o", path("f.cdfr"), "--memory", "1KiB"});
  EXPECT_EQ(tight.status, 2);
  EXPECT_NE(tight.errors.find("needs at least"), std::string::npos) << tight.errors;
  for (const char* size : {"0", "1", "GiB", "1.5GiB", "-1", "1 GiB", "99999999999TiB"}) {
    EXPECT_EQ(run({"build", mesh, "-o", path("f.cdfr"), "--memory", size}).status, 2) << size;
  }
  for (const char* domain : {"all", "band", "band:", "band:0", "band:x", "band:inf"}) {
    EXPECT_EQ(run({"build", mesh, "-o", path("f.cdfr"), "--domain", domain}).status, 2) << domain;
  }
}

TEST_F(FieldTest, APlanIsCloseToTheField) {
  const std::string mesh = part("cylinder-head", "head.stl");
  const json plan = run({"build", mesh, "--plan", "--json"}).json()["plan"];
  const json built = run({"build", mesh, "-o", path("h.cdfr"), "--json"}).json();
  EXPECT_EQ(plan["triangles"], built["triangles"]);
  EXPECT_NEAR(plan["bytes"].get<double>() / built["bytes"].get<double>(), 1, 0.25);
  double leaves = 0;
  for (const auto& kind : built["leaves"]) leaves += kind.get<double>();
  EXPECT_NEAR(plan["leaves"].get<double>() / leaves, 1, 0.25);
  EXPECT_GT(plan["seconds"].get<double>(), 0);
  EXPECT_FALSE(std::filesystem::exists(path("h.cdfr.work")));
  EXPECT_EQ(run({"build", mesh}).status, 2);
}

TEST_F(FieldTest, DamageIsToldByEveryVerb) {
  const std::string mesh = part("cylinder-head", "head.stl");
  ASSERT_EQ(run({"build", mesh, "-o", path("h.cdfr"), "--quiet"}).status, 0);
  std::string bytes = text_of(path("h.cdfr"));
  for (std::size_t at = 300000; at < bytes.size() - 300000; at += 100000) bytes[at] ^= 1;
  put("h.cdfr", bytes);
  put("p.csv", "100,100,100\n10,20,30\n");
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"info", path("h.cdfr")},
           {"info", path("h.cdfr"), "--verify"},
           {"query", path("h.cdfr"), "--points", path("p.csv"), "-o", path("o.csv")},
           {"grid", path("h.cdfr"), "--resolution", "20", "-o", path("g.npy")},
           {"contour", path("h.cdfr"), "--distance", "1", "--tolerance", "5", "-o", path("c.ply")}}) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 1) << words.front();
    EXPECT_NE(outcome.errors.find("damaged"), std::string::npos) << outcome.errors;
  }
  for (const char* name : {"o.csv", "g.npy", "c.ply"})
    EXPECT_FALSE(std::filesystem::exists(path(name))) << name;
}

}  // namespace
}  // namespace cdfr
