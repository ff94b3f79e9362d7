/// Time that other work on the machine does not lengthen.
#pragma once

#include <ctime>

namespace cdfr::bench {

/// Seconds that the processor has worked for this process so far, all its threads together.
inline double processor_seconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace cdfr::bench
