/// A tick that counts what it is told, and cancels in time.
#pragma once

#include <atomic>

namespace cdfr::test {

struct Ticks {
  std::atomic<int> left = 0;  ///< calls until it cancels
  std::atomic<bool> inside = false, twice = false, disorder = false;
  double last = 0;
};

/// For Run::tick; the context is a Ticks.
inline bool count_down(void* context, double done) noexcept {
  auto& ticks = *static_cast<Ticks*>(context);
  if (ticks.inside.exchange(true)) ticks.twice = true;
  if (!(done >= 0 && done <= 1 + 1e-9)) ticks.disorder = true;
  ticks.last = done;
  ticks.inside = false;
  return ticks.left-- > 0;
}

}  // namespace cdfr::test
