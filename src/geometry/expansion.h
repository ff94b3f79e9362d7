/// Exact sums and products of doubles, as expansions: sums of doubles that do not overlap, smallest first.
///
/// Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997:
/// grow-expansion and scale-expansion, which keep components nonadjacent when ties round to even. The type
/// carries the largest number of components, so nothing is allocated; zeros are dropped as they appear. Exact
/// while no product falls below the smallest normal number, which query_range.h and the range of mesh
/// coordinates see to.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/double_double.h"

namespace cdfr {

template <std::size_t Capacity>
class Expansion {
 public:
  /// Adds one double, exactly. At most Capacity times.
  void add(double term) noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const DoubleDouble s = two_sum(term, components_[i]);
      if (s.lo != 0) components_[kept++] = s.lo;
      term = s.hi;
    }
    if (term != 0) components_[kept++] = term;
    size_ = kept;
  }

  std::size_t size() const noexcept { return size_; }
  double operator[](std::size_t i) const noexcept { return components_[i]; }

  /// -1, 0 or 1: the largest component has the sign of the sum.
  int sign() const noexcept {
    if (size_ == 0) return 0;
    return components_[size_ - 1] > 0 ? 1 : -1;
  }

  /// The sum rounded to double-double. Components are nonadjacent, so partial sums from the smallest on at
  /// least double with each step and stay below twice the last component: the errors 3u^2 of each add up to
  /// less than 2^-100.
  DoubleDouble rounded() const noexcept {
    DoubleDouble sum{};
    for (std::size_t i = 0; i < size_; ++i) sum = sum + DoubleDouble{components_[i], 0};
    return sum;
  }

 private:
  std::array<double, Capacity> components_;
  std::size_t size_ = 0;
};

/// a - b exactly.
inline Expansion<2> exact_difference(double a, double b) noexcept {
  const DoubleDouble d = two_difference(a, b);
  Expansion<2> e;
  e.add(d.lo);
  e.add(d.hi);
  return e;
}

template <std::size_t N, std::size_t M>
Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) noexcept {
  Expansion<N + M> sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.add(a[i]);
  for (std::size_t i = 0; i < b.size(); ++i) sum.add(b[i]);
  return sum;
}

template <std::size_t N, std::size_t M>
Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) noexcept {
  Expansion<N + M> sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.add(a[i]);
  for (std::size_t i = 0; i < b.size(); ++i) sum.add(-b[i]);
  return sum;
}

template <std::size_t N, std::size_t M>
Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b) noexcept {
  Expansion<2 * N * M> product;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const DoubleDouble p = two_product(a[i], b[j]);
      product.add(p.lo);
      product.add(p.hi);
    }
  }
  return product;
}

}  // namespace cdfr
