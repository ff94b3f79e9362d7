/// The rules hold on this project, and each of them notices a breach in a made one.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rooms/file_rules.h"
#include "rooms/include_rules.h"
#include "rooms/made_tree.h"
#include "rooms/source_tree.h"

namespace cdfr::rooms {
namespace {

const std::string header = "/// Something.\n#pragma once\n";

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string breaches(const MadeTree& tree) {
  const SourceTree read = read_source_tree(tree.root());
  return joined(include_violations(read)) + joined(file_violations(read));
}

TEST(Project, RoomsIncludeOnlyRoomsToTheirLeft) {
  const SourceTree tree = read_source_tree(CDFR_SOURCE_ROOT);
  ASSERT_GT(tree.files.size(), 100U);
  const std::vector<std::string> violations = include_violations(tree);
  EXPECT_TRUE(violations.empty()) << joined(violations);
}

TEST(Project, FilesKeepTheHouseRules) {
  const std::vector<std::string> violations = file_violations(read_source_tree(CDFR_SOURCE_ROOT));
  EXPECT_TRUE(violations.empty()) << joined(violations);
}

TEST(Rules, AcceptWhatIsAllowed) {
  const MadeTree tree;
  tree.write("include/cdfr/cdfr.h",
             header + "#include \"cdfr/contour/public.h\"\n#include \"cdfr/store/public.h\"\n");
  tree.write("include/cdfr/field/public.h", header + "#include <vector>\n#include \"cdfr/core/public.h\"\n");
  tree.write("src/contour/inner.h", header + "#include \"field/inner.h\"\n#include \"cdfr/version.h\"\n");
  tree.write("tools/cdfr/main.cpp", "#include \"verbs.h\"\n#include \"cdfr/store/public.h\"\n");
  tree.write("tools/cdfr/verbs.h", header + "#include <iostream>\n");
  tree.write("tests/field/own_test.cpp", "#include \"field/inner.h\"\n#include \"cdfr/store/public.h\"\n");
  EXPECT_EQ(breaches(tree), "");
}

struct Breach {
  std::string name, file, text, expected;
};

const std::vector<Breach> include_breaches{
    {"RoomSeesRight", "src/core/inner.h", header + "#include \"field/inner.h\"\n",
     "src/core/inner.h:3: field/inner.h: core must not see field"},
    {"RoomSeesPublicRight", "src/geometry/inner.cpp", "\n  #  include \"cdfr/field/public.h\"\n",
     "src/geometry/inner.cpp:2: cdfr/field/public.h: geometry must not see field"},
    {"PublicSeesRight", "include/cdfr/core/public.h", header + "#include <cdfr/field/public.h>\n",
     "core must not see field"},
    {"Braces", "src/store/inner.cpp", "#include \"contour/inner.h\"\n", "store must not see contour"},
    {"RoomSeesUmbrella", "src/contour/inner.cpp", "#include \"cdfr/cdfr.h\"\n",
     "contour must not see umbrella"},
    {"PublicSeesInner", "include/cdfr/field/public.h", header + "#include \"field/inner.h\"\n",
     "a public header includes what is not public"},
    {"NotRelativeToSource", "src/core/inner.cpp", "#include \"inner.h\"\n", "not written relative to src"},
    {"UnknownRoom", "src/attic/inner.h", header + "#include \"core/inner.h\"\n",
     "file in no room of the design"},
    {"ToolSeesInner", "tools/cdfr/main.cpp", "#include \"field/inner.h\"\n", "only public headers"},
    {"BenchSeesInner", "bench/engine.cpp", "#include \"core/inner.h\"\n", "only public headers"},
    {"TestSeesOtherRoom", "tests/core/a_test.cpp", "#include \"field/inner.h\"\n",
     "a test sees public headers and what its own room sees, not field"},
    {"OracleSeesInner", "tests/oracle/a_test.cpp", "#include \"geometry/inner.h\"\n", "not geometry"},
};

const std::vector<Breach> file_breaches{
    {"LongFile", "src/core/inner.h", header + std::string(599, '\n'), "601 lines, more than 600"},
    {"Unlisted", "src/core/other.cpp", "", "src/core/other.cpp: not listed"},
    {"UnlistedPrefix", "src/core/er.cpp", "", "src/core/er.cpp: not listed"},
    {"Glob", "src/core/CMakeLists.txt", "file(GLOB sources *.cpp)\n# inner.cpp\n", "not globbed"},
    {"Console", "src/core/inner.cpp", "#include <iostream>\n", "<iostream> in the library"},
    {"NoGuard", "include/cdfr/core/public.h", "int a();\n", "no #pragma once"},
    {"NamesTbb", "include/cdfr/core/public.h", header + "#include <tbb/tbb.h>\n", "names TBB or Eigen"},
    {"NamesEigen", "include/cdfr/core/public.h", header + "#include <Eigen/Core>\n", "names TBB or Eigen"},
};

class Breaches : public testing::TestWithParam<Breach> {};

TEST_P(Breaches, AreNoticed) {
  const MadeTree tree;
  ASSERT_EQ(breaches(tree), "");
  tree.write(GetParam().file, GetParam().text);
  EXPECT_NE(breaches(tree).find(GetParam().expected), std::string::npos) << breaches(tree);
}

std::string breach_name(const testing::TestParamInfo<Breach>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Includes, Breaches, testing::ValuesIn(include_breaches), breach_name);
INSTANTIATE_TEST_SUITE_P(Files, Breaches, testing::ValuesIn(file_breaches), breach_name);

TEST(Rules, AnEmptyFolderIsNoticed) {
  const MadeTree tree;
  tree.make_folder("src/core/attic");
  EXPECT_EQ(breaches(tree), "src/core/attic: empty folder\n");
}

}  // namespace
}  // namespace cdfr::rooms
