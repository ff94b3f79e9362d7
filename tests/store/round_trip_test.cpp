// What is loaded is what was saved: every answer bit for bit.
#include <gtest/gtest.h>

#include <cfenv>
#include <string>
#include <vector>

#include "store/stored_bytes.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/same.h"

namespace cdfr {
namespace {

class RoundTrip : public StoreTest {
 protected:
  void check(const Mesh& mesh, const BuildOptions& options = {}, const std::string& unit = "") const {
    const Field field = Field::build(mesh.view(), options).value();
    save(field, file(), unit).value();
    const StoredField stored = load(file()).value();
    EXPECT_EQ(stored.unit, unit);
    expect_same(field, stored.field);
  }
  static void expect_same(const Field& a, const Field& b) {
    EXPECT_EQ(a.checksum(), b.checksum());
    EXPECT_EQ(a.sign(), b.sign());
    EXPECT_EQ(a.bounds(), b.bounds());
    EXPECT_EQ(a.domain(), b.domain());
    const BuildOptions x = a.options(), y = b.options();
    EXPECT_EQ(x.margin, y.margin);
    EXPECT_EQ(x.gain, y.gain);
    EXPECT_EQ(x.max_triangles_per_leaf, y.max_triangles_per_leaf);
    EXPECT_EQ(x.max_level, y.max_level);
    EXPECT_EQ(x.sign, y.sign);
    EXPECT_EQ(x.lists, y.lists);
    expect_same_leaves(a, b);
    test::Random random(11);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = random.in(test::scaled(a.bounds(), i % 4 == 0 ? 5 : 1.2));
      ASSERT_TRUE(test::same_bits(a.closest(p), b.closest(p)));
      ASSERT_TRUE(test::same_bits(a.distance(p), b.distance(p)));
    }
  }
  static void expect_same_leaves(const Field& a, const Field& b) {
    ASSERT_EQ(a.leaf_count(), b.leaf_count());
    for (std::size_t i = 0; i < a.leaf_count(); i += 1 + a.leaf_count() / 50) {
      const Leaf x = a.leaf(i), y = b.leaf(i);
      EXPECT_EQ(x.key, y.key);
      EXPECT_EQ(x.box, y.box);
      EXPECT_EQ(x.side, y.side);
      EXPECT_EQ(x.triangles, y.triangles);
    }
    const Stats s = a.stats(), t = b.stats();
    EXPECT_EQ(s.triangles, t.triangles);
    EXPECT_EQ(s.vertices, t.vertices);
    EXPECT_EQ(s.entries, t.entries);
    EXPECT_EQ(s.max_list, t.max_list);
    EXPECT_EQ(s.mean_list, t.mean_list);
    ASSERT_EQ(s.levels.size(), t.levels.size());
    for (std::size_t i = 0; i < s.levels.size(); ++i) {
      EXPECT_EQ(s.levels[i].cells, t.levels[i].cells);
      EXPECT_EQ(s.levels[i].entries_kept, t.levels[i].entries_kept);
      EXPECT_EQ(s.levels[i].mean_list, t.levels[i].mean_list);
    }
  }
};

TEST_F(RoundTrip, InAnyRoundingModeOfTheCaller) {
  Mesh open = test::sphere_mesh(2);
  open.triangles.pop_back();
  for (const Mesh& mesh : {test::sphere_mesh(2), open}) {
    const Field field = Field::build(mesh.view()).value();
    save(field, file(), "mm").value();
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
      std::fesetround(mode);
      const Result<StoredField> stored = load(file());
      std::fesetround(FE_TONEAREST);
      ASSERT_TRUE(stored) << stored.error().text;
      expect_same(field, stored->field);
    }
  }
}

TEST_F(RoundTrip, OfAClosedMesh) { check(test::sphere_mesh(4), {}, "mm"); }

TEST_F(RoundTrip, OfAnOpenMesh) { check(test::soup(60, {{0, 0, 0}, {1, 2, 3}}, 5)); }

TEST_F(RoundTrip, OfOneTriangle) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  check(mesh);
}

TEST_F(RoundTrip, OfMeshesTurnedInsideOutAndFarAway) {
  Mesh mesh = test::sphere_mesh(2, 0x1p-20, {0x1p10, 0, -0x1p10});
  check(mesh);
  for (Triangle& f : mesh.triangles) std::swap(f[0], f[1]);
  check(mesh);
}

TEST_F(RoundTrip, OfPatches) {
  Mesh mesh = test::sphere_mesh(2);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) mesh.patches.push_back(i * 7 % 5);
  check(mesh);
  const StoredField stored = load(file()).value();
  const Closest c = stored.field.closest({2, 0.1, 0.2});
  EXPECT_EQ(c.patch, mesh.patches[c.triangle]);
}

TEST_F(RoundTrip, OfEveryOption) {
  BuildOptions options;
  options.margin = 0.4;
  options.max_triangles_per_leaf = 3;
  options.max_level = 4;
  options.gain = 0.9;
  options.sign = Sign::none;
  options.lists = Lists::band;
  check(test::sphere_mesh(2), options, "in");
  options.sign = Sign::pseudonormal;
  options.max_level = 0;
  check(test::sphere_mesh(2), options, "m");
}

TEST_F(RoundTrip, OfAnyUnit) {
  std::string every;
  for (int c = 1; c < 256; ++c) every += static_cast<char>(c);
  for (const std::string& unit :
       {std::string(), std::string("\xc2\xb5m"), every, std::string(64, 'x'), std::string("a\0b", 3)}) {
    check(test::box_mesh({{0, 0, 0}, {1, 1, 1}}), {}, unit);
  }
}

TEST_F(RoundTrip, TwiceIsOnce) {
  const Field field = Field::build(test::sphere_mesh(3).view()).value();
  save(field, file("first"), "mm").value();
  const StoredField stored = load(file("first")).value();
  save(stored.field, file("second"), stored.unit).value();
  EXPECT_EQ(bytes_of(file("first")), bytes_of(file("second")));
  expect_same(field, load(file("second")).value().field);
}

TEST_F(RoundTrip, FieldOutlivesItsFile) {
  save(Field::build(test::sphere_mesh(3).view()).value(), file()).value();
  const StoredField stored = load(file()).value();
  std::filesystem::remove(file());
  EXPECT_LT(stored.field.distance({0, 0, 0}), -0.9);
}

}  // namespace
}  // namespace cdfr
