#include "octree/list_length.h"

#include <cmath>

namespace cdfr {
namespace {

constexpr double shortest = 320;

// Measured on spot (23,062 triangles), NIST part 2 (33,664) and a cylinder head (134,480), lists of 160 to
// 2560. Surfaces are thin: a split halves a cell's list or quarters it, and makes up to eight leaves. With
// lists of m triangles there were 1000 to 2000 n m^-1.5 leaves, and each took 5 to 12 us to make. A query
// took 0.6 to 1.3 us, and 0.5 ns more for each triangle of its list, which is 0.4 m in the mean. What any
// build or query takes besides does not matter for the choice. A model that is off by a factor of two moves
// the optimum, m = (3/2 * 1600 n * 10 us / (queries * 0.2 ns))^0.4, by a third, and the time there hardly.
constexpr double leaves_a_triangle = 1600;
constexpr double leaf_microseconds = 10;
constexpr double scan_microseconds = 0.0002;

/// Square roots are the same on any processor, other powers are not.
double microseconds(double length, double triangles, double queries) noexcept {
  const double leaves = leaves_a_triangle * triangles / (length * std::sqrt(length));
  return leaves * leaf_microseconds + queries * scan_microseconds * length;
}

}  // namespace

int list_length_for(std::uint64_t triangles, std::uint64_t queries) noexcept {
  const auto n = static_cast<double>(triangles), q = static_cast<double>(queries);
  double best = shortest;
  // A list of all triangles splits nothing. Less than 2^32 of them: the length stays an int.
  for (double length = 2 * shortest; length / 2 < n && length < 0x1p31; length *= 2) {
    if (microseconds(length, n, q) < microseconds(best, n, q)) best = length;
  }
  return static_cast<int>(best);
}

}  // namespace cdfr
