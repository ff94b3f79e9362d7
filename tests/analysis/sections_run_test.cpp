// Threads, cancel, files, open meshes and refusals of heavy sections, and two revisions.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "analysis/sections_case.h"
#include "cdfr/analysis/section_changes.h"
#include "cdfr/parts/part.h"
#include "cdfr/store/store.h"
#include "support/joined.h"
#include "support/meshes.h"
#include "support/scratch.h"
#include "support/ticks.h"

namespace cdfr {
namespace {

using test::checked_sections;
using test::field_of;

void expect_same(const Sections& a, const Sections& b) {
  ASSERT_EQ(a.sections.size(), b.sections.size());
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.may_join.size(), b.may_join.size());
  for (std::size_t i = 0; i < a.sections.size(); ++i) {
    const Section &x = a.sections[i], &y = b.sections[i];
    EXPECT_EQ(x.ball.centre, y.ball.centre);
    EXPECT_EQ(x.ball.radius, y.ball.radius);
    EXPECT_EQ(x.ball.error, y.ball.error);
    EXPECT_EQ(x.ball.touches, y.ball.touches);
    EXPECT_EQ(x.volume, y.volume);
    EXPECT_EQ(x.volume_error, y.volume_error);
    EXPECT_EQ(x.area, y.area);
    EXPECT_EQ(x.box, y.box);
    EXPECT_EQ(x.triangles, y.triangles);
  }
}

TEST(SectionsRun, AreTheSameForAnyNumberOfThreads) {
  const Field field = field_of(make_part("six-star").value());
  const double depth = field.deepest().value().depth / 2;
  cdfr::Run run;
  run.threads = 1;
  const Sections one = heavy_sections(field, depth, {}, run).value();
  ASSERT_FALSE(one.sections.empty());
  run.threads = 2;
  expect_same(one, heavy_sections(field, depth, {}, run).value());
}

class SectionsFile : public ScratchTest {};

TEST_F(SectionsFile, GivesTheSame) {
  const Field field = field_of(make_part("one-tooth").value());
  const double depth = field.deepest().value().depth * 0.6;
  const std::filesystem::path path = folder() / "field.cdfr";
  ASSERT_TRUE(save(field, path));
  expect_same(heavy_sections(field, depth).value(), heavy_sections(load(path).value().field, depth).value());
}

TEST(SectionsRun, AreTheSameForAnyOctreeButForCells) {
  const Mesh mesh = test::sphere_mesh(3, 2);
  for (const auto domain : {Domain::box, Domain::interior, Domain::band}) {
    BuildOptions options;
    options.domain = domain;
    options.band = domain == Domain::band ? 0.1 : 0;
    const Sections found = checked_sections(field_of(mesh, options), 1, {0.05});
    ASSERT_EQ(found.sections.size(), 1U);
    EXPECT_NEAR(found.sections[0].volume, 4.0 / 3 * std::numbers::pi, found.sections[0].volume_error + 0.6);
  }
  BuildOptions flat;
  flat.max_level = 0;
  EXPECT_EQ(checked_sections(field_of(mesh, flat), 1, {0.05}).sections.size(), 1U);
}

/// Also within one leaf: a field of level 0 has few.
TEST(SectionsRun, TickCancels) {
  BuildOptions flat;
  flat.max_level = 0;
  const Field field = field_of(test::sphere_mesh(4), flat);
  for (const int after : {0, 1, 3, 20, 1000}) {
    test::Ticks ticks;
    ticks.left = after;
    cdfr::Run run;
    run.threads = 2;
    run.tick = test::count_down;
    run.context = &ticks;
    const auto result = heavy_sections(field, 0.3, {0.01}, run);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Code::cancelled);
    EXPECT_FALSE(ticks.twice);
  }
}

TEST(SectionsRun, OfAnOpenBoxEndWhereItsSignDoes) {
  Mesh box = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  box.triangles.resize(10);  // without one side
  const Field field = field_of(box);
  ASSERT_EQ(field.sign(), Sign::winding);
  const Sections found = checked_sections(field, 0.3, {0.02});
  ASSERT_EQ(found.sections.size(), 1U);
  EXPECT_TRUE(found.undecided.empty());
}

TEST(SectionsRun, RefusesByName) {
  const Field field = field_of(test::sphere_mesh(2));
  for (const double depth : {0.0, -1.0, double{NAN}, double{INFINITY}})
    EXPECT_EQ(heavy_sections(field, depth).error().code, Code::bad_option);
  for (const double error : {-1.0, 1e-9, double{NAN}, double{INFINITY}})
    EXPECT_EQ(heavy_sections(field, 0.5, {error}).error().code, Code::bad_option);
  EXPECT_EQ(heavy_sections(field, 0.5, {0, -1}).error().code, Code::bad_option);
  EXPECT_EQ(heavy_sections(field, 0.5, {0, 0, NAN}).error().code, Code::bad_option);
  BuildOptions options;
  options.sign = Sign::none;
  EXPECT_EQ(heavy_sections(field_of(test::sphere_mesh(2), options), 0.5).error().code, Code::not_closed);
}

TEST(SectionsRun, OfTinyHugeAndFarParts) {
  for (const double scale : {1e-30, 1e30}) {
    const Field field = field_of(test::sphere_mesh(3, scale));
    const Sections found = heavy_sections(field, scale / 2).value();
    ASSERT_EQ(found.sections.size(), 1U) << scale;
    EXPECT_NEAR(found.sections[0].ball.radius / scale, 1, 0.05);
  }
  const Field field = field_of(test::box_mesh({{1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 2, 1e6 + 3}}));
  const Sections found = checked_sections(field, 0.25, {0.02});
  ASSERT_EQ(found.sections.size(), 1U);
  EXPECT_NEAR(found.sections[0].volume, 0.5 * 1.5 * 2.5, found.sections[0].volume_error + 1e-6);
}

TEST(SectionsRun, WhatChangedBetweenRevisions) {
  const auto parts = [](double first, double second) {
    Mesh mesh = test::sphere_mesh(3, first);
    return second > 0 ? test::joined(mesh, test::sphere_mesh(3, second, {5, 0, 0})) : mesh;
  };
  const auto of = [&](double first, double second) {
    return heavy_sections(field_of(parts(first, second)), 0.5, {0.02}).value();
  };
  const Sections former = of(1, 1.5);
  const auto fates = [&](const Sections& now) {
    std::vector<SectionFate> all;
    for (const SectionChange& change : section_changes(now, former)) all.push_back(change.fate);
    return all;
  };
  using F = std::vector<SectionFate>;
  EXPECT_EQ(fates(former), (F{SectionFate::same, SectionFate::same}));
  EXPECT_EQ(fates(of(1.2, 1.4)), (F{SectionFate::shrunk, SectionFate::grown}));
  EXPECT_EQ(fates(of(1, 0)), (F{SectionFate::same, SectionFate::gone}));
  EXPECT_EQ(section_changes(former, of(1, 0))[0].fate, SectionFate::added);
}

}  // namespace
}  // namespace cdfr
