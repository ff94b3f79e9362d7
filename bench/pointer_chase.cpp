#include "pointer_chase.h"

#include <utility>

#include "random.h"

namespace cdfr::bench {

PointerChase::PointerChase() : lines_((std::size_t{64} << 20) / sizeof(Line)) {
  const auto count = static_cast<std::uint32_t>(lines_.size());
  for (std::uint32_t i = 0; i < count; ++i) lines_[i].next = i;
  // Sattolo's shuffle: swapping with an earlier place only leaves one cycle through all.
  Random random;
  for (std::uint32_t i = count - 1; i > 0; --i) {
    std::swap(lines_[i].next, lines_[static_cast<std::uint32_t>(random.unit() * i)].next);
  }
}

std::uint32_t PointerChase::follow(std::size_t steps) {
  for (std::size_t i = 0; i < steps; ++i) at_ = lines_[at_].next;
  return at_;
}

}  // namespace cdfr::bench
