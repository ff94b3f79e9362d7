/// What an oracle that does not compute exactly can say of a number.
#pragma once

namespace cdfr::oracle {

/// The truth lies in [low, high].
struct Range {
  double low = 0, high = 0;

  bool meets(double from, double to) const noexcept { return from <= high && to >= low; }
};

}  // namespace cdfr::oracle
