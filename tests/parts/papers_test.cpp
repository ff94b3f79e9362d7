// The numbers that the source papers print for their parts, held by ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>

#include "cdfr/field/field.h"
#include "cdfr/mesh/audit.h"
#include "cdfr/parts/part.h"

namespace cdfr {
namespace {

/// A row of table 1, of section 5.5 (cylinder head) or of the report (two-ended tooth, for which it has no
/// numbers, and engine).
struct Printed {
  std::string_view name;
  std::size_t triangles;  ///< of the next closed mesh: connector and cylinder head are printed with one less
  Vec3 size;
  double depth, last_digit;  ///< greatest depth, and one unit of its last digit
  double derived;            ///< as the part's source says
  double volume;  ///< ours, or judged by table 4 (connector, brevi) or by 40 kg of iron (head, engine)

  friend void PrintTo(const Printed& part, std::ostream* out) { *out << part.name; }
};

class PapersPart : public testing::TestWithParam<Printed> {};

TEST_P(PapersPart, HasThePrintedTrianglesAndBox) {
  const Printed& part = GetParam();
  const MeshReport report = audit(make_part(part.name).value().view()).value();
  EXPECT_TRUE(report.embedded()) << sign_reason(report);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.triangles, part.triangles);
  const Vec3 low = report.box.lo, high = report.box.hi;
  EXPECT_EQ((Vec3{high.x - low.x, high.y - low.y, high.z - low.z}), part.size);
  EXPECT_NEAR(report.volume, part.volume, 0.1 * part.volume);
}

/// The tetrahedron's 0.2113 is more than 5 % from the 0.2 that is printed, but rounds to it.
TEST_P(PapersPart, IsAsDeepAsPrinted) {
  const Printed& part = GetParam();
  const Field field = Field::build(make_part(part.name).value().view()).value();
  const Deepest deepest = field.deepest(0.002 * part.depth).value();
  EXPECT_LE(deepest.depth, part.derived * (1 + 1e-12));
  EXPECT_GE(deepest.depth + deepest.error, part.derived * (1 - 1e-12));
  EXPECT_NEAR(part.derived, part.depth, std::max(0.05 * part.depth, part.last_digit / 2));
}

const double root3 = std::sqrt(3.0);

const Printed parts[] = {{"cube", 12, {5, 5, 5}, 2.5, 0.1, 2.5, 125},
                         {"tetrahedron", 4, {1, 1, 1}, 0.2, 0.1, 1 / (3 + root3), 1.0 / 6},
                         {"one-tooth", 16, {1, 2, 2}, 0.48, 0.01, 0.5, 3},
                         {"two-ended-tooth", 20, {1, 2, 2}, 0.5, 0.01, 0.5, 3},
                         {"six-star", 48, {1, 3, 2 * root3}, 0.49, 0.01, 0.4922288159030868, 3 * root3},
                         {"connector", 328, {6.9, 2.0, 2.9}, 0.5, 0.01, 0.5, 8.3},
                         {"brevi", 1812, {38.1, 34.9, 96.0}, 13, 0.01, 13, 72700},
                         {"cylinder-head", 135430, {480, 266, 157}, 9.5, 0.1, 9.5, 40e6 / 7.2},
                         {"engine", 137924, {600, 300, 250}, 11, 1, 11, 40e6 / 7.2}};

INSTANTIATE_TEST_SUITE_P(Papers, PapersPart, testing::ValuesIn(parts), [](const auto& instance) {
  std::string name(instance.param.name);
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace cdfr
