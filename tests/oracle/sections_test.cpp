// Heavy sections of real parts against a dense grid of exact distances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

#include "cdfr/analysis/sections.h"
#include "oracle/random.h"
#include "oracle/random_solids.h"
#include "oracle/real_parts.h"
#include "oracle/section_oracle.h"

namespace cdfr::oracle {
namespace {

constexpr std::size_t samples = 400'000;

class RealSections : public testing::TestWithParam<Model> {
 protected:
  const Mesh mesh = load(GetParam()).value();
  const Field field = Field::build(mesh.view()).value();
  const Deepest all = field.deepest().value();
  const double deepest = all.depth;
};
INSTANTIATE_TEST_SUITE_P(Parts, RealSections, testing::ValuesIn(real_parts()),
                         [](const auto& model) { return model.param.name; });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealSections);

/// The sections by the patch of the grid that holds their ball's centre.
std::map<std::uint32_t, std::vector<std::size_t>> by_patch(const Sections& sections,
                                                           const SectionGrid& grid) {
  std::map<std::uint32_t, std::vector<std::size_t>> patches;
  for (std::size_t i = 0; i < sections.sections.size(); ++i) {
    patches[grid.patch(sections.sections[i].ball.centre)].push_back(i);
  }
  return patches;
}

// A patch holds its sections whole, so their volumes together lie in its range; the largest of their balls is
// its largest; and each has its box in the patch's.
void expect_patch(const SectionPatch& patch, const Sections& sections,
                  const std::vector<std::size_t>& inside) {
  Range volume{0, 0}, radius{0, 0};
  for (const std::size_t i : inside) {
    const Section& s = sections.sections[i];
    volume.low += s.volume - s.volume_error;
    volume.high += s.volume + s.volume_error;
    radius.low = std::max(radius.low, s.ball.radius);
    radius.high = std::max(radius.high, s.ball.radius + s.ball.error);
    const double e = 2 * sections.error;
    EXPECT_GE(s.box.lo.x, patch.box.lo.x - e);
    EXPECT_GE(s.box.lo.y, patch.box.lo.y - e);
    EXPECT_GE(s.box.lo.z, patch.box.lo.z - e);
    EXPECT_LE(s.box.hi.x, patch.box.hi.x + e);
    EXPECT_LE(s.box.hi.y, patch.box.hi.y + e);
    EXPECT_LE(s.box.hi.z, patch.box.hi.z + e);
  }
  EXPECT_TRUE(patch.volume.meets(volume.low, volume.high))
      << volume.low << " to " << volume.high << " of " << patch.volume.low << " to " << patch.volume.high;
  // Where it is several samples thick; a ridge thinner than that is no slope that the border's cubes could be
  // weighed by.
  if (patch.volume.low > 0.3 * patch.volume.high) {
    const double likely = 0.1 * (patch.volume.high - patch.volume.low);
    EXPECT_TRUE((Range{patch.counted - likely, patch.counted + likely}.meets(volume.low, volume.high)))
        << volume.low << " to " << volume.high << " but counted " << patch.counted << " +- " << likely;
  }
  EXPECT_LE(patch.radius.low, radius.high * (1 + 1e-12));
  EXPECT_GE(patch.radius.high, radius.low);
}

// No section without its patch, no deep patch without its section, and no two sections that samples join.
void expect_agreement(const Sections& sections, const SectionGrid& grid) {
  const auto patches = by_patch(sections, grid);
  EXPECT_FALSE(patches.contains(SectionGrid::none));
  for (std::uint32_t p = 0; p < grid.patches().size(); ++p) {
    const SectionPatch& patch = grid.patches()[p];
    SCOPED_TRACE(testing::Message() << "patch " << p << ", " << patch.parts << " parts, deepest "
                                    << patch.radius.low << " at " << patch.deepest.x << ' ' << patch.deepest.y
                                    << ' ' << patch.deepest.z);
    const auto inside = patches.find(p);
    if (inside == patches.end()) {
      const double told = sections.undecided.empty() ? 1e-12 : 2 * sections.error;
      EXPECT_LE(patch.radius.low, sections.depth + told) << "a deep place in no section";
    } else {
      expect_patch(patch, sections, inside->second);
    }
  }
  std::set<std::uint32_t> parts;
  for (const Section& s : sections.sections) {
    const std::uint32_t part = grid.part(s.ball.centre);
    if (part == SectionGrid::none) continue;
    EXPECT_TRUE(parts.insert(part).second || !sections.may_join.empty()) << "two sections in one part";
  }
}

TEST_P(RealSections, AgreeWithADenseGrid) {
  for (const double share : {0.35, 0.7}) {
    SCOPED_TRACE(share);
    const double depth = share * deepest;
    SectionsOptions options;
    options.error = deepest / 30;
    const Sections sections = heavy_sections(field, depth, options).value();
    const SectionGrid grid(field, depth, samples);
    ASSERT_FALSE(sections.sections.empty());
    expect_agreement(sections, grid);
  }
}

TEST_P(RealSections, HoldTheirBalls) {
  const BruteForce brute = BruteForce::over(mesh.view()).value();
  const Sections sections = heavy_sections(field, 0.6 * deepest).value();
  for (const Section& s : sections.sections) {
    const Closest closest = brute.closest(s.ball.centre);
    EXPECT_NEAR(-closest.distance, s.ball.radius, 1e-12 * deepest);
    EXPECT_TRUE(std::ranges::binary_search(s.ball.touches, closest.triangle));
    EXPECT_GT(s.ball.radius, sections.depth);
  }
  // The largest of all is the part's.
  const double radius = sections.sections.front().ball.radius, error = sections.sections.front().ball.error;
  EXPECT_GE(radius + error, all.depth);
  EXPECT_LE(radius, all.depth + all.error);
}

class RandomSections : public testing::TestWithParam<int> {
 protected:
  Random random{static_cast<std::uint64_t>(GetParam())};
  const Mesh mesh = random_solid(random);
  const Field field = Field::build(mesh.view()).value();
  const double deepest = field.deepest().value().depth;
};
INSTANTIATE_TEST_SUITE_P(Solids, RandomSections, testing::Range(0, 12));

TEST_P(RandomSections, AgreeWithADenseGrid) {
  for (const double share : {0.2, 0.5, 0.8}) {
    SCOPED_TRACE(share);
    expect_agreement(heavy_sections(field, share * deepest).value(),
                     SectionGrid(field, share * deepest, 200'000));
  }
}

bool holds(const Box& outer, const Box& inner, double slack) {
  return outer.lo.x <= inner.lo.x + slack && outer.lo.y <= inner.lo.y + slack &&
         outer.lo.z <= inner.lo.z + slack && outer.hi.x >= inner.hi.x - slack &&
         outer.hi.y >= inner.hi.y - slack && outer.hi.z >= inner.hi.z - slack;
}

// Each section at a depth lies in one at every lesser depth.
TEST_P(RandomSections, Nest) {
  Sections before = heavy_sections(field, 0.15 * deepest).value();
  for (const double share : {0.3, 0.45, 0.6, 0.75, 0.9}) {
    SCOPED_TRACE(share);
    Sections sections = heavy_sections(field, share * deepest).value();
    for (const Section& s : sections.sections) {
      EXPECT_TRUE(std::ranges::any_of(before.sections, [&](const Section& outer) {
        return holds(outer.box, s.box, 4 * sections.error) &&
               outer.ball.radius + outer.ball.error >= s.ball.radius &&
               outer.volume + outer.volume_error >= s.volume - s.volume_error;
      }));
    }
    before = std::move(sections);
  }
}

}  // namespace
}  // namespace cdfr::oracle
