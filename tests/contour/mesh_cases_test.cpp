// The claims on which embedding rests, over all signs at a cell's corners.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <array>
#include <vector>

#include "contour/cell_faces.h"
#include "support/random.h"

namespace cdfr {
namespace {

using Point = Eigen::Vector3d;
using Points = std::vector<Point>;

/// The loops of a case, each as its sides in order.
std::vector<std::vector<int>> loops_of(const SignCase& at) {
  std::vector<std::vector<int>> loops;
  std::array<bool, cell_sides> seen{};
  for (int side = 0; side < cell_sides; ++side) {
    if (at.next[side] < 0 || seen[side]) continue;
    loops.emplace_back();
    for (int k = side; !seen[k]; k = at.next[k]) {
      seen[k] = true;
      loops.back().push_back(k);
    }
  }
  return loops;
}

Point crossing(int side, test::Random& random) {
  const int corner = side_corner(side);
  Point p(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
  p[side_axis(side)] = random.between(0.001, 0.999);
  return p;
}

/// A plane through three of all points with one set on each side: if hulls are disjoint there is one.
bool are_apart(const Points& a, const Points& b) {
  Points all = a;
  all.insert(all.end(), b.begin(), b.end());
  const auto on_side = [](const Points& points, const Point& at, const Point& normal, double sign) {
    for (const Point& p : points) {
      if (sign * normal.dot(p - at) < -1e-12) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      for (std::size_t k = j + 1; k < all.size(); ++k) {
        const Point normal = (all[j] - all[i]).cross(all[k] - all[i]);
        if (normal.norm() < 1e-9) continue;
        for (const double sign : {-1.0, 1.0}) {
          if (on_side(a, all[i], normal, sign) && on_side(b, all[i], normal, -sign)) return true;
        }
      }
    }
  }
  return false;
}

TEST(MeshCases, EveryCrossedSideIsOnOneLoop) {
  for (unsigned held = 0; held < 256; ++held) {
    const SignCase at = sign_case(held);
    int sides = 0;
    for (const auto& loop : loops_of(at)) {
      EXPECT_GE(loop.size(), 3U) << held;
      sides += static_cast<int>(loop.size());
      for (std::size_t i = 0; i < loop.size(); ++i) EXPECT_EQ(at.next[loop[i]], loop[(i + 1) % loop.size()]);
    }
    int crossed = 0;
    for (int side = 0; side < cell_sides; ++side) {
      const int low = side_corner(side), high = low | 1 << side_axis(side);
      crossed += (held >> low & 1U) != (held >> high & 1U);
    }
    EXPECT_EQ(sides, crossed) << held;
    EXPECT_EQ(loops_of(at).size(), static_cast<std::size_t>(at.loops));
  }
}

TEST(MeshCases, NeighboursAgreeOnTheirFace) {
  // A face's pieces seen from one cell are those seen from the other, turned round, whatever the other
  // corners are.
  for (unsigned pattern = 0; pattern < 16; ++pattern) {
    for (int axis = 0; axis < 3; ++axis) {
      unsigned below = 0, above = 0;
      const CellFace high = cell_face(axis, 1), low = cell_face(axis, 0);
      for (int k = 0; k < 4; ++k) {
        if ((pattern >> k & 1U) == 0) continue;
        below |= 1U << high.corners[k];
        above |= 1U << low.corners[k];
      }
      std::array<bool, 4> held{};
      for (int k = 0; k < 4; ++k) held[k] = (pattern >> k & 1U) != 0;
      const FacePieces pieces = face_pieces(held);
      const SignCase in_below = sign_case(below), in_above = sign_case(above);
      for (int i = 0; i < pieces.count; ++i) {
        EXPECT_EQ(in_below.next[high.sides[pieces.from[i]]], high.sides[pieces.to[i]]);
        EXPECT_EQ(in_above.next[low.sides[pieces.to[i]]], low.sides[pieces.from[i]]);
      }
    }
  }
}

TEST(MeshCases, HullsOfOneCellsLoopsAreApart) {
  test::Random random(5);
  int pairs = 0;
  for (unsigned held = 0; held < 256; ++held) {
    const auto loops = loops_of(sign_case(held));
    for (int trial = 0; trial < 40 && loops.size() > 1; ++trial) {
      std::vector<Points> sets;
      for (const auto& loop : loops) {
        sets.emplace_back();
        for (const int side : loop) sets.back().push_back(crossing(side, random));
      }
      for (std::size_t i = 0; i < sets.size(); ++i) {
        for (std::size_t j = i + 1; j < sets.size(); ++j) {
          ++pairs;
          ASSERT_TRUE(are_apart(sets[i], sets[j])) << held;
        }
      }
    }
  }
  EXPECT_GT(pairs, 1000);
}

TEST(MeshCases, WhatIsNotHeldIsOnTheOuterSide) {
  // One held corner: the triangle's normal points away from it.
  test::Random random(6);
  for (int corner = 0; corner < 8; ++corner) {
    const auto loops = loops_of(sign_case(1U << corner));
    ASSERT_EQ(loops.size(), 1U);
    ASSERT_EQ(loops[0].size(), 3U);
    Points p;
    for (const int side : loops[0]) p.push_back(crossing(side, random));
    const Point from(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    EXPECT_GT((p[1] - p[0]).cross(p[2] - p[0]).dot(p[0] - from), 0) << corner;
  }
}

}  // namespace
}  // namespace cdfr
