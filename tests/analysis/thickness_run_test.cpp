// Threads, cancel, fields from files, refusals and meshes that are no part.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cdfr/analysis/thickness.h"
#include "cdfr/parts/part.h"
#include "cdfr/store/store.h"
#include "support/joined.h"
#include "support/meshes.h"
#include "support/same.h"
#include "support/scratch.h"
#include "support/ticks.h"

namespace cdfr {
namespace {

void expect_same(const Thickness& a, const Thickness& b) {
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const ThicknessSample &s = a.samples[i], &t = b.samples[i];
    ASSERT_TRUE(test::same_bits(s.position, t.position) && test::same_bits(s.normal, t.normal) &&
                test::same_bits(s.opposite_point, t.opposite_point))
        << i;
    ASSERT_TRUE(test::same_bits(s.thickness, t.thickness) && test::same_bits(s.error, t.error) &&
                test::same_bits(s.area, t.area))
        << i;
    ASSERT_TRUE(s.triangle == t.triangle && s.opposite == t.opposite && s.at_edge == t.at_edge) << i;
  }
  EXPECT_EQ(a.report.queries, b.report.queries);
  EXPECT_TRUE(test::same_bits(a.report.mean, b.report.mean));
  EXPECT_TRUE(test::same_bits(a.report.facet, b.report.facet));
  EXPECT_EQ(a.report.histogram, b.report.histogram);
  ASSERT_EQ(a.report.places.size(), b.report.places.size());
  for (std::size_t i = 0; i < a.report.places.size(); ++i) {
    EXPECT_TRUE(test::same_bits(a.report.places[i].position, b.report.places[i].position));
    EXPECT_TRUE(test::same_bits(a.report.places[i].area, b.report.places[i].area));
  }
}

TEST(ThicknessRun, SameBytesForAnyThreads) {
  const Field field = Field::build(test::sphere_mesh(4).view()).value();
  for (const ThicknessMethod method : {ThicknessMethod::sphere, ThicknessMethod::ray}) {
    ThicknessOptions options;
    options.method = method;
    options.at = SampleAt::spacing;
    options.spacing = 0.05;
    options.edges = EdgePolicy::extrapolate;
    cdfr::Run run;
    run.threads = 1;
    const Thickness expected = thickness(field, options, run).value();
    EXPECT_GT(expected.samples.size(), 2000U);
    for (const unsigned threads : {2U, 7U, 0U}) {
      run.threads = threads;
      expect_same(thickness(field, options, run).value(), expected);
    }
  }
}

TEST(ThicknessRun, TickCancelsEarlyAndLate) {
  const Field field = Field::build(test::sphere_mesh(4).view()).value();
  for (const ThicknessMethod method : {ThicknessMethod::sphere, ThicknessMethod::ray}) {
    for (const int after : {0, 1, 3}) {
      test::Ticks ticks;
      ticks.left = after;
      cdfr::Run run;
      run.threads = 2;
      run.tick = test::count_down;
      run.context = &ticks;
      ThicknessOptions options;
      options.method = method;
      const auto result = thickness(field, options, run);
      ASSERT_FALSE(result);
      EXPECT_EQ(result.error().code, Code::cancelled);
      EXPECT_FALSE(ticks.twice);
    }
  }
}

TEST(ThicknessRun, RefusesByName) {
  const Mesh box = test::box_mesh({{0, 0, 0}, {3, 4, 5}});
  const Field field = Field::build(box.view()).value();
  BuildOptions unsigned_field;
  unsigned_field.sign = Sign::none;
  EXPECT_EQ(thickness(Field::build(box.view(), unsigned_field).value()).error().code, Code::not_closed);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](auto set) {
    ThicknessOptions options;
    set(options);
    const auto result = thickness(field, options);
    return !result && result.error().code == Code::bad_option;
  };
  EXPECT_TRUE(refused([&](ThicknessOptions& o) { o.facet = nan; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.sharp = 0; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.sharp = 180; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.error = -1; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.error = 1e-15; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.cone = 90; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.rays = 0; }));
  EXPECT_TRUE(refused([&](ThicknessOptions& o) { o.largest = nan; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.thinner_than = -1; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.bins = 0; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.places = -1; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) { o.at = SampleAt::spacing; }));
  EXPECT_TRUE(refused([](ThicknessOptions& o) {
    o.at = SampleAt::spacing;
    o.spacing = 1e-9;
  }));
}

/// The same numbers at any size that is supported, and away from the origin as far as doubles go.
TEST(ThicknessExtremes, ScaleWithThePart) {
  for (const int exponent : {-190, -40, 0, 40, 190}) {
    const double unit = std::ldexp(1.0, exponent);
    Mesh mesh = test::box_mesh({{0, 0, 0}, {8 * unit, 8 * unit, unit}});
    const Field field = Field::build(mesh.view()).value();
    for (const ThicknessMethod method : {ThicknessMethod::sphere, ThicknessMethod::ray}) {
      ThicknessOptions options;
      options.method = method;
      const Thickness found = thickness(field, options).value();
      ASSERT_EQ(found.samples.size(), 12U);
      for (const ThicknessSample& sample : found.samples) {
        if (std::fabs(sample.normal.z) < 0.5) continue;
        EXPECT_NEAR(sample.thickness / unit, 1, 1e-6) << exponent;
      }
    }
  }
  const Field far =
      Field::build(test::moved(test::box_mesh({{0, 0, 0}, {8, 8, 1}}), {1e9, -1e9, 1e9}).view()).value();
  const Thickness of_far = thickness(far).value();
  for (const ThicknessSample& sample : of_far.samples) {
    if (std::fabs(sample.normal.z) > 0.5) {
      EXPECT_NEAR(sample.thickness, 1, 1e-3);
    }
  }
}

TEST(ThicknessExtremes, OpenMeshesAreHeldByTheirSurfaceAlone) {
  Mesh mesh = test::box_mesh({{0, 0, 0}, {8, 8, 1}});
  mesh.triangles.erase(mesh.triangles.begin() + 4, mesh.triangles.begin() + 6);
  const Field field = Field::build(mesh.view()).value();
  ASSERT_EQ(field.sign(), Sign::winding);
  const Thickness found = thickness(field).value();
  for (const ThicknessSample& sample : found.samples) {
    if (std::fabs(sample.normal.z) > 0.5) {
      EXPECT_NEAR(sample.thickness, 1, 1e-6);
    }
  }
}

TEST(ThicknessExtremes, NothingOfAMeshWithoutArea) {
  Mesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  const Field field = Field::build(flat.view()).value();
  for (const SampleAt at : {SampleAt::faces, SampleAt::vertices, SampleAt::spacing}) {
    ThicknessOptions options;
    options.at = at;
    options.spacing = 0.5;
    const Thickness found = thickness(field, options).value();
    EXPECT_TRUE(found.samples.empty());
    EXPECT_TRUE(std::isnan(found.report.mean));
  }
  Mesh single = flat;
  single.vertices[2] = {0, 1, 0};
  const Thickness of_one = thickness(Field::build(single.view()).value()).value();
  ASSERT_EQ(of_one.samples.size(), 1U);
}

/// A sliver of no area, a doubled wall and a turned body are answered, whatever the answer is worth.
TEST(ThicknessExtremes, OfBadMeshesEndInNumbers) {
  Mesh mesh = test::box_mesh({{0, 0, 0}, {3, 4, 5}});
  mesh.triangles.push_back({0, 1, 1});
  mesh.triangles.push_back(mesh.triangles[0]);
  const Mesh soup = test::soup(40, {{0, 0, 0}, {1, 1, 1}}, 3);
  Mesh turned = test::icosphere(1);
  for (Triangle& t : turned.triangles) std::swap(t[1], t[2]);
  for (const Mesh& bad : {mesh, soup, turned}) {
    const Field field = Field::build(bad.view()).value();
    for (const ThicknessMethod method : {ThicknessMethod::sphere, ThicknessMethod::ray}) {
      for (const SampleAt at : {SampleAt::faces, SampleAt::vertices}) {
        ThicknessOptions options;
        options.method = method;
        options.at = at;
        const Thickness found = thickness(field, options).value();
        for (const ThicknessSample& sample : found.samples) {
          if (!std::isnan(sample.thickness)) {
            EXPECT_GE(sample.thickness, 0);
            EXPECT_NE(sample.opposite, no_index);
          }
        }
      }
    }
  }
}

class ThicknessOfFile : public ScratchTest {};

TEST_F(ThicknessOfFile, IsThatOfTheField) {
  const Field field = Field::build(make_part("one-tooth").value().view()).value();
  ASSERT_TRUE(save(field, folder() / "part.cdfr"));
  const StoredField stored = load(folder() / "part.cdfr").value();
  expect_same(thickness(stored.field).value(), thickness(field).value());
}

}  // namespace
}  // namespace cdfr
