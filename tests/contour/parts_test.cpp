// The papers' made parts at the papers' depths, and two real parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"
#include "contour/case.h"
#include "contour/coverage.h"
#include "support/random.h"

namespace cdfr {
namespace {

using test::Case;
using test::Contour;

TEST(ContourOfMadePart, IsThereAtThePapersDepths) {
  const struct {
    const char* name;
    double depth;
  } claims[] = {{"six-star", 0.35}, {"one-tooth", 0.2}};
  for (const auto& claim : claims) {
    SCOPED_TRACE(claim.name);
    const Case part(make_part(claim.name).value());
    const Contour contour = test::contour_of(part.field, -claim.depth, 0.05);
    EXPECT_EQ(contour.report.undecided, 0U);
    EXPECT_GT(contour.points.size(), 50U);
    test::expect_true_points(part, contour, 2);
    test::expect_covered(contour, test::true_contour(part, -claim.depth, part.field.bounds(), 8000, 41));
  }
}

/// `depth` and tolerance as shares of the longest side.
void check_real(const char* file, std::initializer_list<double> shares, double tolerance) {
  const std::filesystem::path path = std::filesystem::path(CDFR_SHARED_DATA) / "public" / file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is missing";
  const Case part(read_mesh(path).value());
  ASSERT_EQ(part.field.sign(), Sign::pseudonormal);
  const Box box = part.field.bounds();
  const double longest = std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
  for (const double share : shares) {
    SCOPED_TRACE(share);
    const Contour contour = test::contour_of(part.field, share * longest, tolerance * longest);
    EXPECT_EQ(contour.report.undecided, 0U);
    ASSERT_FALSE(contour.points.empty());
    test::expect_true_points(part, contour, 1 + contour.points.size() / 200);
    const double grown = share > 0 ? 1.1 + 4 * share : 1;
    test::expect_covered(contour,
                         test::true_contour(part, share * longest, test::scaled(box, grown), 1500, 42));
  }
}

TEST(ContourOfRealPart, Csg) { check_real("openscad/CSG.stl", {-0.03, 0.05}, 0.06); }
TEST(ContourOfRealPart, MountingPlate) { check_real("tess/kcl_mounting-plate.stl", {-0.008, 0.02}, 0.04); }
TEST(ContourOfRealPart, Torus) { check_real("odedstein_meshes/torus.obj", {-0.06, 0.04}, 0.05); }

}  // namespace
}  // namespace cdfr
