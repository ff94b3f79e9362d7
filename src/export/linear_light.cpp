#include "export/linear_light.h"

#include <cstddef>

namespace cdfr {
namespace {

/// By Newton's method from above, which for a in [2^-7, 1] is at rest after 20 steps; a power function of the
/// C library has other bits on other machines.
double fifth_root(double a) noexcept {
  double root = 1;
  for (int step = 0; step < 20; ++step) root = (4 * root + a / (root * root * root * root)) / 5;
  return root;
}

}  // namespace

std::array<float, 256> linear_light() noexcept {
  std::array<float, 256> light{};
  for (std::size_t level = 0; level < light.size(); ++level) {
    const double value = static_cast<double>(level) / 255;
    const double x = (value + 0.055) / 1.055;
    // x^2.4 = x^2 (x^2)^(1/5)
    light[level] = static_cast<float>(value <= 0.04045 ? value / 12.92 : x * x * fifth_root(x * x));
  }
  return light;
}

}  // namespace cdfr
