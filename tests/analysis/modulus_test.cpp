/// Moduli of heavy sections against closed forms, and against points taken at random.
#include "cdfr/analysis/modulus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "analysis/sections_case.h"
#include "analysis/shapes.h"
#include "cdfr/parts/part.h"
#include "support/joined.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/ticks.h"

namespace cdfr::test {
namespace {

/// One section that has those triangles, whatever its depth.
Sections section_of(std::vector<std::uint32_t> triangles, double error = 0.04) {
  Sections sections;
  sections.error = error;
  sections.sections.emplace_back();
  sections.sections[0].triangles = std::move(triangles);
  return sections;
}

std::vector<std::uint32_t> triangles_where(const Mesh& mesh, const std::function<bool(const Vec3&)>& holds) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    if (std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return holds(mesh.vertices[v]); }))
      numbers.push_back(i);
  }
  return numbers;
}

void expect_within(const Modulus& modulus, double volume, double area, double most_share) {
  EXPECT_NEAR(modulus.volume, volume, modulus.volume_error);
  EXPECT_LE(modulus.volume_error, most_share * volume);
  EXPECT_NEAR(modulus.cooling_area, area, 1e-12 * area);
  EXPECT_NEAR(modulus.value, volume / area, modulus.error);
  EXPECT_LE(modulus.error, 1.001 * most_share * volume / area);
}

TEST(Modulus, OfACubeABallAndAPlateIsVolumeOverSurface) {
  for (const Shape& shape : {cube(0.02), ball(0.02), plate(0.02)}) {
    SCOPED_TRACE(shape.name);
    const Field field = field_of(shape.mesh);
    const Sections sections = heavy_sections(field, 0.5, {0.1}).value();
    const std::vector<Modulus> moduli = section_moduli(field, sections).value();
    ASSERT_EQ(moduli.size(), 1U);
    expect_within(moduli[0], field.report().volume, field.report().area, 1e-8);
    EXPECT_NEAR(moduli[0].value, shape.volume / shape.area, 2 * shape.error);
  }
}

// Of a cube's face: the pyramid over it up to the middle.
TEST(Modulus, OfAFaceOfACubeIsThatOfItsPyramid) {
  const Mesh mesh = box_mesh({{0, 0, 0}, {4, 4, 4}});
  const Modulus modulus = section_moduli(field_of(mesh), section_of({0, 1}, 0.02)).value()[0];
  expect_within(modulus, 64.0 / 6, 16, 0.04);
}

// What is closer to the wide faces than to the rim: slices of thickness dz less z all round.
TEST(Modulus, OfTheWideFacesOfAPlate) {
  const Mesh mesh = box_mesh({{0, 0, 0}, {12, 10, 2}});
  const Modulus modulus = section_moduli(field_of(mesh), section_of({0, 1, 2, 3})).value()[0];
  expect_within(modulus, 2 * (120 - 22 + 4.0 / 3), 240, 0.02);
}

// By symmetry; the curved surface leaves less doubt than its cubes hold.
TEST(Modulus, OfHalfABallIsHalfOfIt) {
  const Mesh mesh = sphere_mesh(5, 3);
  const Field field = field_of(mesh);
  const auto half = triangles_where(mesh, [](const Vec3& v) { return v.z >= 0; });
  ASSERT_EQ(half.size(), mesh.triangles.size() / 2);
  expect_within(section_moduli(field, section_of(half)).value()[0], field.report().volume / 2,
                field.report().area / 2, 0.04);
}

TEST(Modulus, OfEachOfTwoBodiesIsItsOwn) {
  const Mesh first = sphere_mesh(4, 2), second = box_mesh({{3, 0, 0}, {6, 3, 3}});
  const Field field = field_of(joined(first, second));
  const Sections sections = heavy_sections(field, 1, {0.02}).value();
  ASSERT_EQ(sections.sections.size(), 2U);
  const std::vector<Modulus> moduli = section_moduli(field, sections).value();
  const Field ball_alone = field_of(first);
  expect_within(moduli[0], ball_alone.report().volume, ball_alone.report().area, 0.005);
  expect_within(moduli[1], 27, 54, 0.01);
}

TEST(Modulus, LeavesOutPatchesThatDoNotCool) {
  Mesh mesh = box_mesh({{0, 0, 0}, {4, 4, 4}});
  for (std::uint32_t i = 0; i < 12; ++i) mesh.patches.push_back(i / 2);
  const Field field = field_of(mesh);
  const Sections sections = heavy_sections(field, 1, {0.05}).value();
  const auto modulus = [&](std::vector<std::uint32_t> patches) {
    return section_moduli(field, sections, {0, std::move(patches)}).value()[0];
  };
  EXPECT_DOUBLE_EQ(modulus({}).value, 4.0 / 6);
  EXPECT_DOUBLE_EQ(modulus({0, 2, 4}).value, 4.0 / 3);
  EXPECT_DOUBLE_EQ(modulus({0, 2, 4, 4, 9}).cooling_area, 48);
  const Modulus warm = modulus({0, 1, 2, 3, 4, 5});
  EXPECT_EQ(warm.cooling_area, 0);
  EXPECT_TRUE(std::isinf(warm.value));
  EXPECT_DOUBLE_EQ(warm.volume, 64);
}

/// Share of the mesh's box that is inside and closest to those triangles, from `count` random points.
double share_at_random(const Field& field, const std::vector<std::uint32_t>& triangles, int count) {
  Random random(11);
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 x = random.in(field.report().box);
    if (field.distance(x) >= 0) continue;
    hits += std::binary_search(triangles.begin(), triangles.end(), field.closest(x).triangle);
  }
  return static_cast<double>(hits) / count;
}

double volume_of(const Box& box) {
  return (box.hi.x - box.lo.x) * (box.hi.y - box.lo.y) * (box.hi.z - box.lo.z);
}

// Four standard deviations of the count.
void expect_as_at_random(const Field& field, const Sections& sections, const std::vector<Modulus>& moduli) {
  constexpr int count = 20000;
  ASSERT_EQ(moduli.size(), sections.sections.size());
  for (std::size_t i = 0; i < moduli.size(); ++i) {
    const double box = volume_of(field.report().box);
    const double share = share_at_random(field, sections.sections[i].triangles, count);
    const double deviation = std::sqrt(std::max(share * (1 - share), 1.0 / count) / count);
    EXPECT_NEAR(moduli[i].volume, share * box, moduli[i].volume_error + 4 * deviation * box) << i;
    EXPECT_LT(moduli[i].volume_error, 0.5 * moduli[i].volume) << i;
  }
}

TEST(Modulus, OfPartsIsWhatRandomPointsSay) {
  for (const char* part : {"one-tooth", "six-star"}) {
    SCOPED_TRACE(part);
    const Field field = field_of(make_part(part).value());
    const Sections sections = heavy_sections(field, field.deepest().value().depth * 0.7).value();
    ASSERT_FALSE(sections.sections.empty());
    expect_as_at_random(field, sections, section_moduli(field, sections).value());
  }
}

TEST(Modulus, OfOneWeightOfADumbbell) {
  const Field field = field_of(dumbbell(0.05).mesh);
  const Sections sections = heavy_sections(field, 1.2, {0.02}).value();
  ASSERT_EQ(sections.sections.size(), 2U);
  const std::vector<Modulus> moduli = section_moduli(field, sections).value();
  expect_as_at_random(field, sections, moduli);
  EXPECT_GT(moduli[0].value, moduli[1].value);
}

// Not embedded: walls lie inside the other body, and which side they are on is not plain everywhere.
TEST(Modulus, OfBodiesThatCrossAndOfAnOpenOne) {
  const Mesh crossed = joined(box_mesh({{0, 0, 0}, {2, 2, 2}}), box_mesh({{1, 1, 1}, {3, 3, 3.5}}));
  Mesh open = box_mesh({{0, 0, 0}, {1, 1, 1}});
  open.triangles.resize(10);
  for (const Mesh& mesh : {crossed, open}) {
    const Field field = field_of(mesh);
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    for (const Sections& sections : {section_of(all, 0.01), section_of({0, 1, 2, 3}, 0.01)})
      expect_as_at_random(field, sections, section_moduli(field, sections).value());
  }
}

TEST(Modulus, IsTheSameForAnyNumberOfThreads) {
  const Field field = field_of(dumbbell(0.1).mesh);
  const Sections sections = heavy_sections(field, 1.2, {0.05}).value();
  cdfr::Run run;
  run.threads = 1;
  const std::vector<Modulus> one = section_moduli(field, sections, {}, run).value();
  run.threads = 2;
  const std::vector<Modulus> two = section_moduli(field, sections, {}, run).value();
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].volume, two[i].volume);
    EXPECT_EQ(one[i].volume_error, two[i].volume_error);
    EXPECT_EQ(one[i].value, two[i].value);
  }
}

TEST(Modulus, TickCancels) {
  const Field field = field_of(box_mesh({{0, 0, 0}, {4, 4, 4}}));
  for (const int after : {0, 1, 10}) {
    Ticks ticks;
    ticks.left = after;
    cdfr::Run run;
    run.threads = 2;
    run.tick = count_down;
    run.context = &ticks;
    const auto result = section_moduli(field, section_of({0, 1}), {}, run);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Code::cancelled);
    EXPECT_FALSE(ticks.twice);
    EXPECT_FALSE(ticks.disorder);
  }
}

TEST(Modulus, RefusesByName) {
  const Mesh mesh = box_mesh({{0, 0, 0}, {4, 4, 4}});
  const Field field = field_of(mesh);
  for (const double error : {-1.0, 1e-9, double{NAN}, double{INFINITY}})
    EXPECT_EQ(section_moduli(field, section_of({0}), {error}).error().code, Code::bad_option);
  EXPECT_EQ(section_moduli(field, section_of({0}, 0)).error().code, Code::bad_option);
  EXPECT_EQ(section_moduli(field, section_of({12})).error().code, Code::bad_option);
  BuildOptions options;
  options.sign = Sign::none;
  EXPECT_EQ(section_moduli(field_of(mesh, options), section_of({0})).error().code, Code::not_closed);
  EXPECT_TRUE(section_moduli(field, heavy_sections(field, 3).value()).value().empty());
}

TEST(Modulus, OfTinyHugeAndFarParts) {
  for (const double scale : {1e-30, 1e30}) {
    const Field field = field_of(box_mesh({{0, 0, 0}, {scale, scale, scale}}));
    const Modulus modulus = section_moduli(field, section_of({0, 1}, 0.01 * scale)).value()[0];
    EXPECT_NEAR(modulus.value / scale, 1.0 / 6, modulus.error / scale);
    EXPECT_LT(modulus.error, 0.2 * modulus.value);
  }
  const Field field = field_of(box_mesh({{1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 1, 1e6 + 1}}));
  expect_within(section_moduli(field, section_of({0, 1}, 0.005)).value()[0], 1.0 / 6, 1, 0.1);
}

}  // namespace
}  // namespace cdfr::test
