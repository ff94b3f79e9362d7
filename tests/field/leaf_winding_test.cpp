// What leaves know of the winding number, against exact rays and sums over all triangles.
#include "field/leaf_winding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cdfr/field/field.h"
#include "cdfr/mesh/flip.h"
#include "field/boundary.h"
#include "field/field_data.h"
#include "field/winding.h"
#include "geometry/angle_sum.h"
#include "mesh/crossings.h"
#include "support/joined.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/winding.h"

namespace cdfr {
namespace {

const Box unit{{0, 0, 0}, {1, 1, 1}};

Mesh holed_sphere() {
  Mesh mesh = test::sphere_mesh(4);
  mesh.triangles.resize(mesh.triangles.size() - 75);
  return mesh;
}

Mesh open_box() {
  Mesh mesh = test::box_mesh({{0, 0, 0}, {4, 4, 4}});
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);  // the top
  return mesh;
}

Field field_of(const Mesh& mesh, int level) {
  BuildOptions options;
  options.sign = Sign::winding;
  options.max_level = level;
  options.max_triangles_per_leaf = 24;
  return Field::build(mesh.view(), options).value();
}

/// In the box, and close to the surface at all scales.
Vec3 point_near(const Field& field, test::Random& random, std::size_t i) {
  const Vec3 p = random.in(test::scaled(field.bounds(), 1.1));
  if (i % 2 == 0) return p;
  const double off = std::ldexp(test::longest(field.bounds()), -2 - static_cast<int>(random.below(30)));
  const Vec3 q = field.closest(p).point, shift = random.in({{-1, -1, -1}, {1, 1, 1}});
  return {q.x + off * shift.x, q.y + off * shift.y, q.z + off * shift.z};
}

/// No leaf contradicts the slow way, and few leave it to that.
void expect_agreement(const Mesh& mesh, std::size_t points, double most_open, const char* name) {
  for (const int level : {0, 2, 4}) {
    const Field field = field_of(mesh, level);
    const FieldData& data = field.data();
    test::Random random(static_cast<std::uint64_t>(level) + 7);
    std::size_t asked = 0, open = 0, wrong = 0;
    for (std::size_t i = 0; i < points; ++i) {
      const Vec3 p = point_near(field, random, i);
      if (field.distance(p) == 0 || !data.index.contains(p)) continue;
      const std::uint32_t leaf = data.index.leaf(data.index.place(p));
      const Side side = data.index.at(data.index.place(p), leaf).side;
      if (side == Side::inside || side == Side::outside) continue;
      const bool inside = data.winding.empty() ? winding_by_crossings(p, data.space()) > 0
                                               : winds(data.winding, data.space(), p);
      const int by_leaf = side_by_leaf(data, p);
      ++asked;
      open += by_leaf == 0;
      wrong += by_leaf != 0 && (by_leaf < 0) != inside;
      EXPECT_EQ(field.distance(p) < 0, inside) << name;
    }
    EXPECT_EQ(wrong, 0U) << name << " level " << level;
    EXPECT_LE(static_cast<double>(open), most_open * static_cast<double>(asked))
        << name << " level " << level;
  }
}

TEST(LeafWinding, AgreesWithRaysWhereBodiesMeetCrossAndHoldEachOther) {
  const Mesh cube = test::box_mesh(unit);
  Mesh inward = test::sphere_mesh(3);
  flip(inward);
  expect_agreement(test::joined(cube, test::moved(cube, {1, 0, 0})), 2000, 0.01, "cubes face to face");
  expect_agreement(test::joined(cube, test::moved(cube, {1, 0.25, 0.25})), 2000, 0.01, "faces overlapping");
  expect_agreement(test::joined(cube, test::moved(cube, {0.5, 0.25, 0.5})), 2000, 0.01, "crossing");
  expect_agreement(test::joined(cube, cube), 1000, 0.01, "a cube twice");
  expect_agreement(test::joined(test::sphere_mesh(3), test::sphere_mesh(3, 1, {0.7, 0.1, 0.2})), 1000, 0.01,
                   "spheres crossing");
  expect_agreement(test::joined(test::sphere_mesh(3, 2), test::sphere_mesh(2, 1)), 1000, 0.01, "nested");
  expect_agreement(inward, 1000, 0.01, "inside out");
  expect_agreement(test::joined(cube, inward), 1000, 0.01, "a cube and an inward sphere");
}

TEST(LeafWinding, AgreesWithWindsOnOpenMeshes) {
  expect_agreement(open_box(), 2000, 0.25, "open box");
  expect_agreement(holed_sphere(), 1000, 0.25, "holed sphere");
  expect_agreement(test::soup(60, unit, 9), 500, 1, "soup");
  Mesh half = test::sphere_mesh(3);
  for (std::size_t i = 0; i < half.triangles.size(); i += 2)
    std::swap(half.triangles[i][1], half.triangles[i][2]);
  expect_agreement(half, 500, 1, "half flipped");
  Mesh doubled = test::box_mesh(unit);
  doubled.triangles.push_back(doubled.triangles[0]);
  expect_agreement(doubled, 1000, 0.25, "a face twice");
}

/// Points in planes of faces, above edges and corners, where passages are decided exactly or not at all.
TEST(LeafWinding, AgreesAtPointsInLineWithFacesAndEdges) {
  const Mesh cube = test::box_mesh({{0, 0, 0}, {4, 4, 4}});
  for (const Mesh& mesh : {test::joined(cube, test::moved(cube, {4, 1, 1})), open_box()}) {
    const Field field = field_of(mesh, 3);
    const FieldData& data = field.data();
    for (int i = 0; i < 17 * 17 * 17; ++i) {
      const Vec3 p{i % 17 * 0.5, i / 17 % 17 * 0.5 - 1, i / 289 * 0.5 - 1};
      const double w = test::brute_winding(mesh.view(), p);
      if (field.distance(p) == 0 || std::fabs(w - 0.5) < 1e-6) continue;
      EXPECT_EQ(field.distance(p) < 0, w > 0.5);
      const int side = side_by_leaf(data, p);
      EXPECT_TRUE(side == 0 || (side < 0) == (w > 0.5));
    }
  }
}

TEST(LeafWinding, WhatTheBoundaryChangesIsWithinItsDrift) {
  for (const Mesh& mesh : {open_box(), holed_sphere()}) {
    const Field field = field_of(mesh, 1);
    const FieldData& data = field.data();
    const Boundary& boundary = data.winding.boundary;
    test::Random random(11);
    int sharp = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3 c = random.in(test::scaled(field.bounds(), 1.2));
      const double radius = std::fabs(field.distance(c)) * 0.99;
      const double budget = i % 2 == 0 ? 0.25 : 0.01;
      const auto part = boundary_around(boundary, data.space(), c, radius, budget, boundary.edges.size());
      ASSERT_TRUE(part);
      EXPECT_LE(part->drift, budget * 1.001);
      const Vec3 shift = random.in({{-0.57, -0.57, -0.57}, {0.57, 0.57, 0.57}});
      const Vec3 way{shift.x * radius, shift.y * radius, shift.z * radius};
      const Vec3 p{c.x + way.x, c.y + way.y, c.z + way.z};
      AngleSum swept;
      for (const std::uint32_t e : part->near)
        swept.add_swept(p, c, boundary.edges[e].from, boundary.edges[e].to);
      const Vec3& g = part->gradient;
      const double change = g.x * way.x + g.y * way.y + g.z * way.z + swept.sum().value / four_pi;
      const double truth = test::brute_winding(mesh.view(), p) - test::brute_winding(mesh.view(), c);
      EXPECT_NEAR(change, truth, part->drift + 1e-9);
      sharp += std::fabs(change - truth) < std::fabs(truth) / 2;
    }
    EXPECT_GT(sharp, 200);  // the gradient points the right way
  }
}

}  // namespace
}  // namespace cdfr
