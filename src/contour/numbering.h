/// Numbers for 64-bit keys, in the order in which they are first met.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "cdfr/core/types.h"

namespace cdfr {

class Numbering {
 public:
  /// The key's number, and whether it is new.
  std::pair<std::uint32_t, bool> number(std::uint64_t key) {
    if (2 * (keys_.size() + 1) > buckets_.size()) grow();
    for (std::uint64_t at = mixed(key) & (buckets_.size() - 1);; at = (at + 1) & (buckets_.size() - 1)) {
      if (buckets_[at] == no_index) {
        buckets_[at] = static_cast<std::uint32_t>(keys_.size());
        keys_.push_back(key);
        return {buckets_[at], true};
      }
      if (keys_[buckets_[at]] == key) return {buckets_[at], false};
    }
  }
  std::size_t size() const noexcept { return keys_.size(); }

 private:
  /// The finisher of Steele, Lea, Flood, "Fast splittable pseudorandom number generators" (2014).
  static std::uint64_t mixed(std::uint64_t x) noexcept {
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9U;
    x = (x ^ x >> 27) * 0x94d049bb133111ebU;
    return x ^ x >> 31;
  }
  void grow() {
    buckets_.assign(buckets_.empty() ? 1024 : 2 * buckets_.size(), no_index);
    for (std::uint32_t i = 0; i < keys_.size(); ++i) {
      std::uint64_t at = mixed(keys_[i]) & (buckets_.size() - 1);
      while (buckets_[at] != no_index) at = (at + 1) & (buckets_.size() - 1);
      buckets_[at] = i;
    }
  }

  std::vector<std::uint64_t> keys_;     ///< by number
  std::vector<std::uint32_t> buckets_;  ///< open addressing; a power of two
};

}  // namespace cdfr
