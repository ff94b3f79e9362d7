/// How storeys rise and sink over a plan, so that floors become domes and square openings round ones.
#pragma once

#include <span>

namespace cdfr {

/// At the height `level` the solid rises by `by`; between two such heights by what lies in between.
struct Rise {
  double level = 0, by = 0;
};

/// The height z after the rises, on the plan's grid. Precondition: their levels ascend, from z or below it to
/// z or above it.
double risen(double z, std::span<const Rise> rises) noexcept;

/// 1 up to `from`, 0 beyond `to`.
double fade(double value, double from, double to) noexcept;

/// Half the chord of a circle at that distance from its centre, 0 beyond the circle.
double half_chord(double radius, double offset) noexcept;

}  // namespace cdfr
