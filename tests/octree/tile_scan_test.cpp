#include "octree/tile_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "octree/scan_scene.h"
#include "support/instruction_sets.h"

namespace cdfr {
namespace {

using test::anywhere;
using test::edge;
using test::on_every_instruction_set;
using test::origin;
using test::Scene;

/// Groups of every shape within `spread` of a place, and a store of them in which nothing is shared.
struct Made {
  Scene scene;
  TriangleStore store;
  Vec3 middle;

  Made(test::Random& random, double spread, double largest) : middle(anywhere(random, 0.7)) {
    scene.centre = middle;
    for (int i = 0; i < 4; ++i) {
      const double size = largest * std::ldexp(1.0, -static_cast<int>(random.below(10)));
      const Box near{{middle.x - spread, middle.y - spread, middle.z - spread},
                     {middle.x + spread, middle.y + spread, middle.z + spread}};
      scene.add(test::shaped_group(random, test::all_shapes[random.below(6)], random.in(near), size), 0xff);
    }
    std::vector<ExactTriangle> exact;
    std::vector<TriangleRecord> records;
    for (const test::ShapedGroup& made : scene.groups) {
      for (const TriangleShape& shape : made.shapes) exact.push_back({shape, 0, 0});
    }
    for (std::uint32_t slot = 0; slot < scene.groups.size() * group_size; ++slot) {
      const std::array<std::uint32_t, 3> ids{3 * slot, 3 * slot + 1, 3 * slot + 2};
      records.push_back({ids, ids, slot, Sides::unknown, {}});
    }
    store = {std::move(exact), std::move(records)};
  }

  Foot foot(const Vec3& p, std::uint32_t slot) const {
    return measure(p, scene.groups[slot / group_size].shapes[slot % group_size]);
  }
};

/// Points within `radius` of the middle, some of them on a feature or off it by a random power of two.
std::vector<Vec3> points_near(test::Random& random, const Made& made, double radius) {
  std::vector<Vec3> points;
  while (points.size() < TilePoints::most) {
    const Vec3& m = made.middle;
    Vec3 p =
        random.in({{m.x - radius, m.y - radius, m.z - radius}, {m.x + radius, m.y + radius, m.z + radius}});
    if (random.below(3) == 0) {
      const auto& shape = made.scene.groups[random.below(4)].shapes[random.below(group_size)];
      const Vec3 on = test::along(shape.vertices[0], shape.vertices[1], random.between(0, 1));
      const Vec3 q =
          test::along(test::along(on, shape.vertices[2], random.below(2) == 0 ? 0 : random.between(0, 1)), p,
                      std::ldexp(1.0, -static_cast<int>(random.below(50))));
      const double away = std::max({std::fabs(q.x - m.x), std::fabs(q.y - m.y), std::fabs(q.z - m.z)});
      if (away <= radius) p = q;
    }
    points.push_back(p);
  }
  return points;
}

struct Tile {
  TileList list;
  std::vector<std::uint16_t> numbers;
  TilePoints points{};

  Tile(const Made& made, const std::vector<Vec3>& at, double radius) {
    Lattice lattice{};
    lattice.origin = origin;
    lattice.edge = edge;
    const Vec3 middle = test::in_edges(made.middle);
    EXPECT_TRUE(list.fill(made.store, lattice, made.scene.list, middle,
                          std::sqrt(3.0) * radius / edge * (1 + 1e-12)));
    for (std::size_t n = 0; n < list.triangles.size(); ++n) numbers.push_back(static_cast<std::uint16_t>(n));
    for (const Vec3& p : at) {
      const Vec3 q = test::in_edges(p);
      points.at[0][points.count] = static_cast<float>(q.x - middle.x);
      points.at[1][points.count] = static_cast<float>(q.y - middle.y);
      points.at[2][points.count++] = static_cast<float>(q.z - middle.z);
    }
  }
};

std::vector<std::size_t> closest(const Made& made, const Tile& tile, const Vec3& p) {
  DoubleDouble least{HUGE_VAL, 0};
  for (const std::uint32_t slot : tile.list.slots) least = std::min(least, made.scene.squared(p, slot));
  std::vector<std::size_t> winners;
  for (std::size_t n = 0; n < tile.list.slots.size(); ++n) {
    if (made.scene.squared(p, tile.list.slots[n]) == least) winners.push_back(n);
  }
  return winners;
}

/// Winners by double-double are kept; where one is named with a place, it is the only one, and its foot is
/// there.
void check_findings(const Made& made, const Tile& tile, const std::vector<Vec3>& at,
                    const TileFindings& found, std::size_t& alone) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::vector<std::size_t> winners = closest(made, tile, at[i]);
    const auto place = static_cast<TrianglePlace>(found.place[i]);
    if (place != unsure_place) {
      ++alone;
      const auto number = static_cast<std::size_t>(found.number[i]);
      ASSERT_EQ(winners, std::vector<std::size_t>{number});
      const Foot foot = made.foot(at[i], tile.list.slots[number]);
      ASSERT_EQ(foot.place, place);
      ASSERT_TRUE(place == 0 || foot.squared.hi > 0);
      continue;
    }
    std::vector<std::size_t> kept;
    for (std::uint64_t left = found.kept[i]; left != 0; left &= left - 1) {
      kept.push_back(found.survivors[static_cast<std::size_t>(std::countr_zero(left))]);
    }
    std::sort(kept.begin(), kept.end());
    ASSERT_TRUE(std::includes(kept.begin(), kept.end(), winners.begin(), winners.end()));
  }
}

TEST(TileScan, KeepsWinnersAndPlacesTheirFeet) {
  on_every_instruction_set([] {
    test::Random random(71);
    std::size_t alone = 0;
    for (int i = 0; i < 300; ++i) {
      const double radius = 0.5 * std::ldexp(1.0, -static_cast<int>(random.below(8)));
      const Made made(random, radius * 4, radius * std::ldexp(1.0, static_cast<int>(random.below(6)) - 3));
      const std::vector<Vec3> at = points_near(random, made, radius);
      const Tile tile(made, at, radius);
      TileFindings found;
      ASSERT_TRUE(scan_tile(tile.list, tile.numbers, tile.points, found));
      check_findings(made, tile, at, found, alone);
      if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(alone, 300U * TilePoints::most / 4);
  });
}

TEST(TileScan, PrunesOnlyWhatIsClosestNowhereInTheBox) {
  on_every_instruction_set([] {
    test::Random random(72);
    std::size_t dropped = 0;
    for (int i = 0; i < 300; ++i) {
      const double radius = 0.25 * std::ldexp(1.0, -static_cast<int>(random.below(8)));
      const Made made(random, radius * 4, radius * std::ldexp(1.0, static_cast<int>(random.below(6)) - 3));
      const std::vector<Vec3> at = points_near(random, made, radius);
      const Tile tile(made, at, radius);
      TileBox box;
      for (int axis = 0; axis < 3; ++axis) {
        const auto [lo, hi] =
            std::minmax_element(tile.points.at[axis], tile.points.at[axis] + tile.points.count);
        box.lo[axis] = *lo;
        box.hi[axis] = *hi;
      }
      std::vector<std::uint16_t> kept(tile.numbers.size());
      kept.resize(prune(tile.list, tile.numbers, box, kept.data()));
      dropped += tile.numbers.size() - kept.size();
      for (const Vec3& p : at) {
        for (const std::size_t winner : closest(made, tile, p)) {
          ASSERT_TRUE(std::binary_search(kept.begin(), kept.end(), winner));
        }
      }
    }
    EXPECT_GT(dropped, 300U);
  });
}

}  // namespace
}  // namespace cdfr
