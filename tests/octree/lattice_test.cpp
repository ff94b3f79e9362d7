#include "octree/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/box_distance.h"
#include "support/random.h"

namespace cdfr {
namespace {

/// Every corner of the deepest level must be a double: origin + k * finest has no rounding for any k.
bool corners_are_exact(const Lattice& l) {
  const double finest = l.size(deepest_level);
  const auto exact = [&](double origin, std::uint32_t bricks) {
    const double last = origin + bricks * l.edge;
    const bool multiples = std::fmod(origin, finest) == 0 && std::fmod(last, finest) == 0;
    return multiples && std::max(std::fabs(origin), std::fabs(last)) <= finest * 0x1p53;
  };
  return exact(l.origin.x, l.bricks[0]) && exact(l.origin.y, l.bricks[1]) && exact(l.origin.z, l.bricks[2]);
}

TEST(Lattice, CoversTheGrownBoxWithExactCornersAtAnySizeAndPlace) {
  test::Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const double size = std::ldexp(random.between(1, 2), static_cast<int>(random.below(380)) - 190);
    const double away = size * std::ldexp(1.0, static_cast<int>(random.below(40)));
    const double scale = std::min(1.0, 0x1p198 / away);
    const auto at = [&] { return scale * random.between(-away, away); };
    const Vec3 lo{at(), at(), at()};
    const Box box{lo,
                  {lo.x + size * random.between(0, 1), lo.y + size, lo.z + size * random.between(0, 0.01)}};
    const Lattice l = lattice_for(box, 0.05);
    EXPECT_TRUE(corners_are_exact(l));
    EXPECT_TRUE(contains(l.domain(), box.lo));
    EXPECT_TRUE(contains(l.domain(), box.hi));
    EXPECT_LE(*std::max_element(l.bricks.begin(), l.bricks.end()), 8U);
    EXPECT_GE(*std::min_element(l.bricks.begin(), l.bricks.end()), 1U);
  }
}

TEST(Lattice, TakesABoxThatIsAPointAtTheOrigin) {
  const Lattice l = lattice_for({{0, 0, 0}, {0, 0, 0}}, 0.05);
  EXPECT_TRUE(contains(l.domain(), {0, 0, 0}));
  EXPECT_TRUE(corners_are_exact(l));
}

TEST(Lattice, CutsALongPartIntoABrickOfCubes) {
  const Lattice l = lattice_for({{0, 0, 0}, {800, 100, 90}}, 0);
  EXPECT_EQ(l.edge, 128);
  EXPECT_EQ(l.bricks, (std::array<std::uint32_t, 3>{7, 1, 1}));
}

}  // namespace
}  // namespace cdfr
