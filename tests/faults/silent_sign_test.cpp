// Where the sign of a mesh cannot be trusted, the caller is told: what was chosen, why, and how many of what
// are wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cdfr/field/field.h"
#include "cdfr/mesh/audit.h"
#include "cdfr/mesh/flip.h"
#include "cdfr/store/store.h"
#include "faults/block_solid.h"
#include "faults/star.h"
#include "support/joined.h"
#include "support/scratch.h"
#include "support/winding.h"

namespace cdfr {
namespace {

const Box unit{{0, 0, 0}, {1, 1, 1}};

Mesh cube() { return test::block(unit).mesh(); }

Mesh without_last(Mesh mesh, std::size_t count = 1) {
  mesh.triangles.resize(mesh.triangles.size() - count);
  return mesh;
}

Mesh with_one_turned() {
  Mesh mesh = cube();
  std::swap(mesh.triangles[3][1], mesh.triangles[3][2]);
  return mesh;
}

Mesh turned(Mesh mesh) {
  flip(mesh);
  return mesh;
}

struct Defect {
  std::string named;  ///< in the reason
  Mesh mesh;
  std::uint64_t MeshReport::*count;
};

std::vector<Defect> defects() {
  const Mesh lower = test::block({{0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}}).mesh();
  const test::BlockSolid by_an_edge({0, 1, 2}, {0, 1, 2}, {0, 1}, [](int i, int j, int) { return i == j; });
  const test::BlockSolid by_a_corner({0, 1, 2}, {0, 1, 2}, {0, 1, 2},
                                     [](int i, int j, int k) { return i == j && j == k; });
  Mesh doubled = cube();
  doubled.triangles.push_back(doubled.triangles[5]);
  return {{"open edge", without_last(cube()), &MeshReport::open_edges},
          {"flipped edge", with_one_turned(), &MeshReport::flipped_edges},
          {"non-manifold edge", by_an_edge.mesh(), &MeshReport::nonmanifold_edges},
          {"non-manifold vert", by_a_corner.mesh(), &MeshReport::nonmanifold_vertices},
          {"duplicate triangle", doubled, &MeshReport::duplicate_triangles},
          {"touch or cross others", test::joined(cube(), test::moved(cube(), {0.5, 0.4, 0.3})),
           &MeshReport::touching_triangles},
          {"inside out", turned(cube()), &MeshReport::turned_shells},
          {"nested", test::joined(cube(), lower), &MeshReport::turned_shells}};
}

TEST(SilentSign, EveryDefectIsNamedAndCountedAndChangesThePolicy) {
  for (const Defect& defect : defects()) {
    const Field field = Field::build(defect.mesh.view()).value();
    EXPECT_FALSE(field.report().embedded()) << defect.named;
    EXPECT_EQ(field.sign(), Sign::winding) << defect.named;
    EXPECT_GT(field.report().*defect.count, 0U) << defect.named;
    const std::string reason = sign_reason(field.report());
    EXPECT_NE(reason.find(defect.named), std::string::npos) << reason;
    EXPECT_EQ(reason.find('\n'), std::string::npos);
  }
}

TEST(SilentSign, ValidMeshesRaiseNoAlarm) {
  const Mesh inner = test::block({{0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}}).mesh();
  for (const Mesh& mesh :
       {cube(), test::spiky_star(2, 1), test::many_fans(104), test::joined(cube(), turned(inner)),
        test::joined(cube(), test::moved(cube(), {1 + 1e-9, 0, 0}))}) {
    const Field field = Field::build(mesh.view()).value();
    EXPECT_EQ(field.sign(), Sign::pseudonormal);
    EXPECT_EQ(sign_reason(field.report()), "closed, outward and embedded");
  }
}

/// A policy that was asked for by name is used and reported, and does not silence the audit.
TEST(SilentSign, APolicyByNameIsKeptAndTheWarningToo) {
  const Mesh open = without_last(cube());
  for (const Sign sign : {Sign::automatic, Sign::pseudonormal, Sign::winding, Sign::none}) {
    BuildOptions options;
    options.sign = sign;
    const Field field = Field::build(open.view(), options).value();
    EXPECT_EQ(field.sign(), sign == Sign::automatic ? Sign::winding : sign);
    EXPECT_EQ(field.options().sign, sign);
    EXPECT_EQ(field.report().open_edges, 3U);
    EXPECT_NE(sign_reason(field.report()).find("3 open edges"), std::string::npos);
    EXPECT_EQ(field.distance({0.5, 0.5, 0.5}) < 0, sign != Sign::none);
  }
}

/// On open and crossing input the sign is that of the winding number, no less and no more.
TEST(SilentSign, OpenAndCrossingMeshesAreSignedByTheirWinding) {
  for (const Mesh& mesh : {without_last(cube(), 3), without_last(test::spiky_star(1, 2), 5),
                           test::joined(cube(), test::moved(cube(), {0.5, 0.4, 0.3})), turned(cube()),
                           test::soup(20, unit, 3)}) {
    const Field field = Field::build(mesh.view()).value();
    test::Random random(4);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 p = random.in(test::scaled(field.bounds(), 1.4));
      const double w = test::brute_winding(mesh.view(), p);
      if (std::fabs(w - 0.5) < 1e-12) continue;
      ASSERT_EQ(field.distance(p) < 0, w > 0.5) << w;
    }
  }
}

class SilentSignFile : public ScratchTest {};

TEST_F(SilentSignFile, TheWarningSurvivesAFile) {
  int number = 0;
  for (const Defect& defect : defects()) {
    const Field field = Field::build(defect.mesh.view()).value();
    const auto path = folder() / (std::to_string(number++) + ".cdfr");
    ASSERT_TRUE(save(field, path));
    const Field back = load(path).value().field;
    EXPECT_EQ(back.sign(), field.sign());
    EXPECT_EQ(sign_reason(back.report()), sign_reason(field.report()));
    EXPECT_EQ(back.report().*defect.count, field.report().*defect.count);
  }
}

}  // namespace
}  // namespace cdfr
