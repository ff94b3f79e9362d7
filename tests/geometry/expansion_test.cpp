#include "geometry/expansion.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace cdfr {
namespace {

__extension__ using Wide = __int128;

/// Integers of 60 bits as sums of doubles; products of two are exact in 128 bits.
Expansion<2> whole(std::int64_t n) {
  Expansion<2> e;
  const double hi = static_cast<double>(n);
  e.add(static_cast<double>(n - static_cast<std::int64_t>(hi)));
  e.add(hi);
  return e;
}

template <std::size_t N>
Wide value(const Expansion<N>& e) {
  Wide sum = 0;
  for (std::size_t i = 0; i < e.size(); ++i) sum += static_cast<Wide>(e[i]);
  return sum;
}

TEST(Expansion, SumsAndProductsAreExactIntegers) {
  test::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto a = static_cast<std::int64_t>(random.bits()) >> (4 + random.below(50));
    const auto b = static_cast<std::int64_t>(random.bits()) >> (4 + random.below(50));
    EXPECT_TRUE(value(whole(a) * whole(b)) == static_cast<Wide>(a) * b);
    EXPECT_TRUE(value(whole(a) + whole(b)) == static_cast<Wide>(a) + b);
    EXPECT_TRUE(value(whole(a) - whole(b)) == static_cast<Wide>(a) - b);
  }
}

TEST(Expansion, SignSeesWhatCancellationLeaves) {
  const Expansion<2> a = exact_difference(1, 0x1p-100);
  const Expansion<2> b = exact_difference(1, 0x1p-99);
  EXPECT_EQ((a - b).sign(), 1);
  EXPECT_EQ((b - a).sign(), -1);
  EXPECT_EQ((a - a).sign(), 0);
  EXPECT_EQ((a * b - b * a).sign(), 0);
}

TEST(DoubleDouble, SquareRootIsCorrectlyRoundedOnSquares) {
  test::Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const double d = random.between(0.5, 4);
    EXPECT_EQ(square_root(two_product(d, d)), d);
  }
  EXPECT_EQ(square_root({0, 0}), 0);
}

}  // namespace
}  // namespace cdfr
