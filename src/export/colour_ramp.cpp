#include <array>
#include <cmath>
#include <cstddef>

#include "cdfr/export/painted.h"

namespace cdfr {
namespace {

/// Lightness (CIE L*) falls by 14 to 17 from each to the next, 90 to 11 in all, and falls too as people see
/// them who lack the red or the green receptors. Grey as light as no_value is nowhere near.
constexpr std::array<Colour, 6> controls{
    {{255, 224, 96}, {247, 164, 66}, {218, 108, 78}, {168, 60, 112}, {104, 30, 128}, {28, 14, 88}}};
constexpr Colour no_value{205, 205, 205};

/// Where the value lies in the range, 0 to 1.
double share_of(double value, double least, double greatest) noexcept {
  if (value <= least) return value == greatest ? 0.5 : 0;
  if (value >= greatest) return 1;
  const double width = greatest - least;
  // A range may be wider than the largest double; its half is not.
  return std::isfinite(width) ? (value - least) / width
                              : (value / 2 - least / 2) / (greatest / 2 - least / 2);
}

}  // namespace

Colour painted_colour(double value, double least, double greatest) noexcept {
  if (std::isnan(value)) return no_value;
  constexpr std::size_t steps = controls.size() - 1;
  const double along = share_of(value, least, greatest) * steps;
  const auto first = along < steps ? static_cast<std::size_t>(along) : steps - 1;
  const double share = along - static_cast<double>(first);
  Colour colour{};
  for (std::size_t k = 0; k < colour.size(); ++k) {
    const double from = controls[first][k], to = controls[first + 1][k];
    colour[k] = static_cast<std::uint8_t>(from + share * (to - from) + 0.5);
  }
  return colour;
}

}  // namespace cdfr
