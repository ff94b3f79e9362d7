#include "octree/scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "octree/scan_scene.h"
#include "support/instruction_sets.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

using test::anywhere;
using test::edge;
using test::on_every_instruction_set;
using test::origin;
using test::Scene;
using test::ShapedGroup;
using test::Shapes;

std::uint8_t some_lanes(test::Random& random) { return static_cast<std::uint8_t>(1 + random.below(255)); }

Scene random_scene(test::Random& random, std::size_t count, double largest) {
  Scene scene;
  scene.centre = anywhere(random);
  for (std::size_t i = 0; i < count; ++i) {
    const double size = largest * std::ldexp(1.0, -static_cast<int>(random.below(12)));
    const Shapes shapes = test::all_shapes[random.below(6)];
    scene.add(test::shaped_group(random, shapes, anywhere(random, size), size), some_lanes(random));
  }
  return scene;
}

/// Anywhere, on a vertex, or off a face, an edge or the line of an edge by a random power of two.
Vec3 query_at(test::Random& random, const TriangleShape& triangle) {
  const auto& [a, b, c] = triangle.vertices;
  const Vec3 p = anywhere(random);
  if (random.below(4) == 0) return p;
  if (random.below(4) == 0) return a;
  const double off = std::ldexp(1.0, -static_cast<int>(random.below(60)));
  if (random.below(3) == 0) return test::along(test::along(a, b, random.between(-1, 2)), p, off);
  const Vec3 on = test::along(test::along(a, b, random.between(0, 1)), c,
                              random.below(2) == 0 ? 0 : random.between(0, 1));
  return test::along(on, p, off);
}

Vec3 query_at(test::Random& random, const Scene& scene) {
  return query_at(random, scene.groups[random.below(scene.groups.size())].shapes[random.below(group_size)]);
}

/// How far from the point a candidate may be: an estimate is off by half of k d + s D + f, so the upper bound
/// is within 1.5 (s D + f) + 2.5 k d of the least distance d, the threshold within 2.5 (s D + f) + 4.5 k d,
/// and what is under it within 3 and 5 of those, but for squares of k.
double farthest_candidate(const Scene& scene, double least) {
  double reach = 0;
  for (const Entry& entry : scene.list) {
    if (entry.is_group()) reach = std::max<double>(reach, scene.scan_groups[entry.number()].reach());
  }
  return least + 5.5 * scan_error * least + 3.25 * (scan_share * reach + scan_floor);
}

/// Every winner by double-double is a candidate, all candidates are on the list, once, and about as close.
void check(const Scene& scene, const Vec3& p, const Candidates& candidates) {
  const std::set<std::uint32_t> found(candidates.slots.begin(), candidates.slots.begin() + candidates.count);
  ASSERT_EQ(found.size(), candidates.count);
  std::set<std::uint32_t> listed;
  DoubleDouble least{HUGE_VAL, 0};
  for (const Entry& entry : scene.list) {
    if (!entry.is_group()) continue;
    for (std::uint32_t lane = 0; lane < group_size; ++lane) {
      if ((entry.lanes() >> lane & 1U) == 0) continue;
      const std::uint32_t slot = entry.number() * std::uint32_t{group_size} + lane;
      listed.insert(slot);
      least = std::min(least, scene.squared(p, slot));
    }
  }
  const double farthest = farthest_candidate(scene, square_root(least) / edge);
  for (const std::uint32_t slot : listed) {
    ASSERT_TRUE(found.contains(slot) || least < scene.squared(p, slot)) << "slot " << slot;
  }
  for (const std::uint32_t slot : found) {
    ASSERT_TRUE(listed.contains(slot));
    ASSERT_LE(square_root(scene.squared(p, slot)) / edge, farthest);
  }
}

TEST(Scan, EstimatesStayWithinTheirBound) {
  on_every_instruction_set([] {
    test::Random random(1);
    for (int i = 0; i < 30000; ++i) {
      Scene scene = random_scene(random, 1, 4 * edge);
      const auto lane = static_cast<std::uint32_t>(random.below(group_size));
      scene.list[0] = Entry::of_group(0, 0, static_cast<std::uint8_t>(1U << lane));
      const Vec3 p = query_at(random, scene.groups[0].shapes[lane]);
      Candidates found;
      ASSERT_TRUE(scene.scan(p, found));
      ASSERT_EQ(found.count, 1U);
      ASSERT_EQ(found.slots[0], lane);
      const double estimate = std::sqrt(double{found.squared[0]});
      const double exact = square_root(scene.squared(p, lane)) / edge;
      const double most =
          (scan_error * estimate + scan_share * double{scene.scan_groups[0].reach()} + scan_floor) / 2;
      ASSERT_LE(std::fabs(estimate - exact), most);
    }
  });
}

TEST(Scan, FindsTheClosestAmongFewGroupsOfAllSizesAndShapes) {
  on_every_instruction_set([] {
    test::Random random(2);
    for (int i = 0; i < 3000; ++i) {
      const Scene scene = random_scene(random, 1 + random.below(6), 4 * edge);
      const Vec3 p = query_at(random, scene);
      Candidates found;
      ASSERT_TRUE(scene.scan(p, found));
      ASSERT_NO_FATAL_FAILURE(check(scene, p, found));
    }
  });
}

TEST(Scan, FindsTheClosestWhereListsGoOnBeyondIt) {
  on_every_instruction_set([] {
    test::Random random(3);
    for (int i = 0; i < 200; ++i) {
      const Scene scene = random_scene(random, 200, 0.25 * edge);
      const Vec3 p = test::along(scene.centre, query_at(random, scene), random.between(0, 1));
      Candidates found;
      ASSERT_TRUE(scene.scan(p, found));
      ASSERT_NO_FATAL_FAILURE(check(scene, p, found));
    }
  });
}

/// A leaf of that size, with groups all around it.
Scene leaf_scene(test::Random& random, std::size_t count, double size) {
  Scene scene;
  scene.size = size;
  scene.centre = anywhere(random, size * edge);
  for (std::size_t i = 0; i < count; ++i) {
    const double extent = 2 * edge * std::ldexp(1.0, -static_cast<int>(random.below(12)));
    const Vec3 middle = test::along(scene.centre, anywhere(random, extent), random.between(0, 1));
    scene.add(test::shaped_group(random, test::all_shapes[random.below(6)], middle, extent),
              some_lanes(random));
  }
  return scene;
}

Vec3 in_leaf(test::Random& random, const Scene& scene) {
  if (random.below(8) == 0) return scene.corner(random.below(8));
  return random.in({scene.corner(0), scene.corner(7)});
}

TEST(Scan, FindsTheClosestByBoundsThatHoldInTheLeaf) {
  on_every_instruction_set([] {
    test::Random random(6);
    for (int i = 0; i < 400; ++i) {
      const double size = std::ldexp(1.0, -static_cast<int>(random.below(6)));
      const Scene scene = leaf_scene(random, 1 + random.below(150), size);
      for (int k = 0; k < 4; ++k) {
        const Vec3 p = in_leaf(random, scene);
        Candidates found;
        ASSERT_TRUE(scene.scan(p, found));
        ASSERT_NO_FATAL_FAILURE(check(scene, p, found));
      }
    }
  });
}

/// A triangle of size 2 eight times over, about level.
ShapedGroup plate(const Vec3& middle, double tilt) {
  ShapedGroup made;
  const Vec3 a{middle.x - 1, middle.y - 1, middle.z - tilt}, b{middle.x + 1, middle.y - 1, middle.z + tilt},
      c{middle.x, middle.y + 1, middle.z};
  for (std::size_t lane = 0; lane < group_size; ++lane) test::put(made, lane, {a, b, c});
  return made;
}

TEST(Scan, FindsALargeTriangleThatIsCloserByLittleThanTinyOnesBeforeIt) {
  on_every_instruction_set([] {
    test::Random random(4);
    for (int i = 0; i < 2000; ++i) {
      Scene scene;
      scene.centre = {origin.x + 2 + random.between(-0.1, 0.1), origin.y + 2, origin.z + 2};
      const Vec3 p = scene.centre;
      const double height = random.between(1e-4, 1e-3), tiny = 1e-7;
      for (int before = 0; before < 2; ++before) {
        scene.add(test::shaped_group(random, Shapes::any, {p.x, p.y, p.z - height - 1.1e-7}, tiny), 0xff);
      }
      scene.add(plate({p.x, p.y, p.z + height}, random.between(0, 1e-5)), some_lanes(random));
      // Distances may be lower than they need be: the plate comes last.
      for (Entry& entry : scene.list) {
        entry = Entry::of_group(entry.number(), entry.number() == 2 ? 1e-4 : 0, entry.lanes());
      }
      std::sort(scene.list.begin(), scene.list.end());
      Candidates found;
      ASSERT_TRUE(scene.scan(p, found));
      ASSERT_NO_FATAL_FAILURE(check(scene, p, found));
    }
  });
}

/// A sphere's triangles in groups, as seen from its centre.
Scene sphere_scene(int times) {
  Scene scene;
  scene.centre = {origin.x + 2, origin.y + 2, origin.z + 2};
  const Mesh mesh = test::sphere_mesh(times, 1, scene.centre);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += group_size) {
    ShapedGroup made;
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      const Triangle& v = mesh.triangles[t + lane];
      test::put(made, lane, {mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]});
    }
    scene.add(made, 0xff);
  }
  return scene;
}

TEST(Scan, GivesUpWhereTooManyAreEquallyClose) {
  Scene plates;
  plates.centre = {origin.x + 2, origin.y + 2, origin.z + 2};
  for (int i = 0; i < 9; ++i) plates.add(plate(plates.centre, 0), 0xff);
  const Scene sphere = sphere_scene(5);
  on_every_instruction_set([&] {
    Candidates found;
    EXPECT_FALSE(plates.scan({plates.centre.x, plates.centre.y, plates.centre.z + 0.5}, found));
    EXPECT_GE(found.upper * edge, 0.5);
    EXPECT_LE(found.upper * edge, 0.501);
    EXPECT_FALSE(sphere.scan(sphere.centre, found));
  });
}

TEST(Scan, AnswersNearASphereAndOffItsCentre) {
  const Scene scene = sphere_scene(3);
  on_every_instruction_set([&] {
    test::Random random(5);
    for (int i = 0; i < 200; ++i) {
      const Vec3 to = anywhere(random);
      const Vec3 p = test::along(scene.centre, to, random.between(0.1, 1));
      Candidates found;
      ASSERT_TRUE(scene.scan(p, found));
      ASSERT_NO_FATAL_FAILURE(check(scene, p, found));
    }
  });
}

/// Half of the groups stand in the list as nodes, with the others around them.
TEST(Scan, GoesOnBelowNodes) {
  on_every_instruction_set([] {
    test::Random random(7);
    for (int i = 0; i < 500; ++i) {
      Scene scene = random_scene(random, 2 + random.below(30), 0.5 * edge);
      for (Entry& entry : scene.list) entry = Entry::of_group(entry.number(), entry.distance(), 0xff);
      const Scene whole = scene;
      scene.grow_tree();
      const auto node = static_cast<std::uint32_t>(random.below(scene.bvh.nodes.size()));
      const BvhNode& in_its_place = scene.bvh.nodes[node];
      double least = HUGE_VAL;
      std::erase_if(scene.list, [&](const Entry& entry) {
        const bool below =
            entry.number() >= in_its_place.first_group && entry.number() < in_its_place.end_group;
        if (below) least = std::min<double>(least, entry.distance());
        return below;
      });
      scene.list.push_back(Entry::of_node(node, least));
      std::sort(scene.list.begin(), scene.list.end());
      const Vec3 p = query_at(random, whole);
      Candidates found;
      ASSERT_TRUE(scene.scan(p, found));
      ASSERT_NO_FATAL_FAILURE(check(whole, p, found));
    }
  });
}

TEST(Scan, LeavesANodeBeyondReachAlone) {
  on_every_instruction_set([] {
    Scene scene;
    scene.centre = {origin.x + 2, origin.y + 2, origin.z + 2};
    scene.add(plate({scene.centre.x, scene.centre.y, scene.centre.z - 0.25}, 0), 0xff);
    scene.add(plate({scene.centre.x, scene.centre.y, scene.centre.z + 0.25}, 0), 0xff);
    scene.grow_tree();
    Candidates found;
    scene.list[1] = Entry::of_node(2, 0.5);
    ASSERT_TRUE(scene.scan(scene.centre, found));
    EXPECT_EQ(found.count, 16U);
    scene.list[1] = Entry::of_node(2, 0.501);
    ASSERT_TRUE(scene.scan(scene.centre, found));
    EXPECT_EQ(found.count, 8U);
  });
}

TEST(Scan, FindsNothingInAnEmptyList) {
  Candidates found;
  EXPECT_TRUE(Scene{}.scan(origin, found));
  EXPECT_EQ(found.count, 0U);
}

}  // namespace
}  // namespace cdfr
