/// How long this machine takes for a read that cannot start before the last one has ended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdfr::bench {

/// One random cycle through all cache lines of 64 MB, more than the caches nearest to a core hold.
class PointerChase {
 public:
  PointerChase();
  /// Follows the cycle; returns where it got to, so that no compiler leaves it out.
  std::uint32_t follow(std::size_t steps);

 private:
  struct alignas(64) Line {
    std::uint32_t next;
  };
  std::vector<Line> lines_;
  std::uint32_t at_ = 0;
};

}  // namespace cdfr::bench
