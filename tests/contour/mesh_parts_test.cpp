// Real parts at distances in and out: closed, embedded, and where they should be. Tolerances are coarse for
// the time that CGAL takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "cdfr/mesh/read.h"
#include "contour/surface.h"
#include "contour/surface_oracle.h"

namespace cdfr {
namespace {

struct RealPart {
  const char* file;
  double tolerance;  ///< share of the longest side
};
std::ostream& operator<<(std::ostream& out, const RealPart& part) { return out << part.file; }

/// Sanitized code takes ten times as long: a coarser surface there.
#ifdef __SANITIZE_ADDRESS__
constexpr double coarser = 3;
#else
constexpr double coarser = 1;
#endif

class MeshOfRealPart : public testing::TestWithParam<RealPart> {};

TEST_P(MeshOfRealPart, IsClosedEmbeddedAndNear) {
  const std::filesystem::path path = std::filesystem::path(CDFR_SHARED_DATA) / "public" / GetParam().file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is missing";
  if (!test::has_surface_oracle()) RecordProperty("cgal", "was not found");
  const Mesh mesh = read_mesh(path).value();
  const Field field = Field::build(mesh.view()).value();
  const BruteForce brute = BruteForce::over(mesh.view(), field.sign()).value();
  const Box box = field.bounds();
  const double longest = std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
  const double tolerance = coarser * GetParam().tolerance * longest;
  for (const double share : {-0.03, -0.008, 0.01, 0.06}) {
    SCOPED_TRACE(share);
    const double distance = share * longest;
    const ContourMesh contour = test::surface_of(field, distance, tolerance);
    EXPECT_EQ(contour.report.loose, 0U);
    if (contour.mesh.triangles.empty()) continue;
    EXPECT_LE(test::largest_excess(field, contour.mesh, distance, 20000), tolerance);
    EXPECT_LE(test::largest_excess(brute, contour.mesh, distance, 100), tolerance);
    // What is missing is listed.
    EXPECT_LE(test::largest_gap(field, contour.mesh, distance, tolerance * 4, contour.report.places),
              tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Public, MeshOfRealPart,
    testing::Values(RealPart{"openscad/CSG.stl", 0.01}, RealPart{"openscad/example009.stl", 0.03},
                    RealPart{"mikedh_trimesh/20mm-xyz-cube.stl", 0.02},
                    RealPart{"mikedh_trimesh/plate_holes.STL", 0.01},
                    RealPart{"tess/kcl_mounting-plate.stl", 0.01},
                    RealPart{"tess/kcl_focusrite-scarlett-mounting-bracket_d3_a60.stl", 0.01},
                    RealPart{"odedstein_meshes/torus.obj", 0.03},
                    RealPart{"odedstein_meshes/wingnut.obj", 0.02}, RealPart{"LLNL_axom_data/cap.stl", 0.02},
                    RealPart{"tess/NIST_MBE_PMI_1_d3_a40.stl", 0.02}));

}  // namespace
}  // namespace cdfr
