#include "cdfr/parts/part.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

#include "parts/depth_probe.h"
#include "parts/mesh_check.h"

namespace cdfr {
namespace {

using test::check_mesh;
using test::DepthProbe;
using test::MeshCheck;

TEST(Part, UnknownNamesAreNamedErrors) {
  for (const std::string name : {"", "Cube", "cube ", "cylinder_head", "brevi-2"}) {
    const Result<Mesh> result = make_part(name);
    ASSERT_FALSE(result) << name;
    EXPECT_EQ(result.error().code, Code::bad_option);
    EXPECT_NE(result.error().text.find("six-star"), std::string::npos);
  }
  EXPECT_FALSE(make_part(std::string_view{}));
}

TEST(Part, EveryPartIsAClosedSolid) {
  for (const std::string_view name : part_names()) {
    const Mesh mesh = make_part(name).value();
    const MeshCheck check = check_mesh(mesh);
    EXPECT_EQ(check.lone_edges, 0U) << name;
    EXPECT_EQ(check.repeated_edges, 0U) << name;
    EXPECT_EQ(check.pinched, 0U) << name;
    EXPECT_EQ(check.unused, 0U) << name;
    EXPECT_EQ(check.twins, 0U) << name;
    EXPECT_EQ(check.components, 1U) << name;
    EXPECT_GT(check.smallest_area, 0) << name;
    EXPECT_GT(check.volume, 0) << name;
  }
}

struct Row {
  std::string_view name;
  std::size_t triangles;
  Vec3 size;
  double depth;  ///< as derived at the part; papers_test.cpp holds it to the printed one
  Vec3 deepest;
  double volume;

  friend void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }
};

class TableRow : public testing::TestWithParam<Row> {};

TEST_P(TableRow, MatchesThePaper) {
  const Row row = GetParam();
  const Mesh mesh = make_part(row.name).value();
  const MeshCheck check = check_mesh(mesh);
  EXPECT_EQ(mesh.triangles.size(), row.triangles);
  EXPECT_NEAR(check.box.hi.x - check.box.lo.x, row.size.x, 1e-15);
  EXPECT_NEAR(check.box.hi.y - check.box.lo.y, row.size.y, 1e-15);
  EXPECT_NEAR(check.box.hi.z - check.box.lo.z, row.size.z, 1e-15);
  EXPECT_NEAR(check.volume, row.volume, 1e-12 * row.volume);
  const DepthProbe probe(mesh, row.size.x / 4);
  EXPECT_TRUE(
      probe.inside({row.deepest.x + 0.001, row.deepest.y + 0.002, row.deepest.z}));  // off the diagonals
  EXPECT_NEAR(probe.distance(row.deepest), row.depth, 1e-14);
  EXPECT_TRUE(probe.deeper_than(row.depth * 1.01, row.depth * 0.005).empty());
}

const double root3 = std::sqrt(3.0);
const double corner_radius = 1 / (3 + root3);
const double star_cosine = std::sqrt(0.75 / (0.75 + 1.0 / 4096));
const double star_radius = 0.5 * star_cosine / (1 + star_cosine / 64);

/// The star's dish takes a pyramid from either face: a third of the face's area, 3 sqrt(3), times 1/64.
INSTANTIATE_TEST_SUITE_P(
    Table1, TableRow,
    testing::Values(Row{"cube", 12, {5, 5, 5}, 2.5, {2.5, 2.5, 2.5}, 125},
                    Row{"tetrahedron",
                        4,
                        {1, 1, 1},
                        corner_radius,
                        {corner_radius, corner_radius, corner_radius},
                        1.0 / 6},
                    Row{"one-tooth", 16, {1, 2, 2}, 0.5, {0.5, 0.6, 0.6}, 3},
                    Row{"two-ended-tooth", 20, {1, 2, 2}, 0.5, {0.5, 0.6, 1}, 3},
                    Row{"six-star",
                        48,
                        {1, 3, 2 * root3},
                        star_radius,
                        {0.5, star_radius - 1, 0},
                        3 * root3*(1 - 2.0 / 192)}));

TEST(Part, CopiesStandSideBySideAndKeepTheirShape) {
  constexpr std::uint64_t copies = 3;
  for (const std::string_view name : part_names()) {
    const Mesh one = make_part(name).value(), all = make_part(name, copies).value();
    const MeshCheck single = check_mesh(one), check = check_mesh(all);
    EXPECT_EQ(check.lone_edges, 0U) << name;
    EXPECT_EQ(check.repeated_edges, 0U) << name;
    EXPECT_EQ(check.pinched, 0U) << name;
    EXPECT_EQ(check.components, copies) << name;
    EXPECT_NEAR(check.volume, copies * single.volume, 1e-11 * check.volume) << name;
    ASSERT_EQ(all.triangles.size(), copies * one.triangles.size()) << name;
    ASSERT_EQ(all.vertices.size(), copies * one.vertices.size()) << name;

    EXPECT_EQ(single.box.lo.x, 0) << name;
    const double width = single.box.hi.x;
    const double step = std::ceil(1.1 * width * 0x1p10) * 0x1p-10;
    for (std::size_t i = 0; i < all.vertices.size(); ++i) {
      const Vec3 v = all.vertices[i], first = one.vertices[i % one.vertices.size()];
      const double shift = step * static_cast<double>(i / one.vertices.size());
      ASSERT_EQ(v, (Vec3{first.x + shift, first.y, first.z})) << name;
      ASSERT_TRUE(v.x - shift == first.x || name == "connector" || name == "brevi") << name;
    }
  }
}

TEST(Part, AFarCopyKeepsItsShape) {
  const Mesh one = make_part("one-tooth").value(), all = make_part("one-tooth", 100000).value();
  const double step = all.vertices[one.vertices.size()].x;
  for (std::size_t i = 0; i < one.vertices.size(); ++i) {
    EXPECT_EQ(all.vertices[all.vertices.size() - one.vertices.size() + i].x - 99999 * step,
              one.vertices[i].x);
  }
}

TEST(Part, TooFewOrTooManyCopiesAreNamedErrors) {
  for (const std::uint64_t copies :
       {std::uint64_t{0}, std::uint64_t{0xfffffffe / 12 + 1}, ~std::uint64_t{0}}) {
    const Result<Mesh> result = make_part("cube", copies);
    ASSERT_FALSE(result) << copies;
    EXPECT_EQ(result.error().code, Code::bad_option);
  }
  EXPECT_NE(make_part("cube", 1000000000).error().text.find("357913941 copies of cube"), std::string::npos);
}

TEST(Part, EveryCallGivesTheSameBits) {
  for (const std::string_view name : part_names()) {
    const Mesh first = make_part(name).value();
    const Mesh second = make_part(name).value();
    EXPECT_EQ(first.vertices, second.vertices) << name;
    EXPECT_EQ(first.triangles, second.triangles) << name;
  }
}

std::uint64_t hash_of(const Mesh& mesh) {
  std::uint64_t hash = 0;
  const auto add = [&](std::uint64_t word) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29U;
  };
  for (const Vec3& v : mesh.vertices) {
    for (const double c : {v.x, v.y, v.z}) add(std::bit_cast<std::uint64_t>(c));
  }
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) add(corner);
  }
  return hash;
}

/// The same on every machine; a change here changes every table made from the part.
TEST(Part, BitsAreFixed) {
  EXPECT_EQ(hash_of(make_part("connector").value()), 3341320993756696816U);
  EXPECT_EQ(hash_of(make_part("brevi").value()), 14660127188244437038U);
  EXPECT_EQ(hash_of(make_part("cylinder-head").value()), 15086194651762486952U);
  EXPECT_EQ(hash_of(make_part("engine").value()), 13796115847493665512U);
}

}  // namespace
}  // namespace cdfr
