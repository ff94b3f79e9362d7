/// Damage that no checksum tells.
#pragma once

#include <xxhash.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "core/guarded_map.h"
#include "store/format.h"

namespace cdfr {

/// Gives bytes, of whatever content, the checksums that fit them where they have room for any.
inline void seal(std::string& bytes) {
  format::Head head;
  format::Counts counts;
  if (bytes.size() < format::first_section) return;
  std::memcpy(&counts, bytes.data() + sizeof head, sizeof counts);
  std::memcpy(&head, bytes.data(), sizeof head);
  head.directory_hash = XXH64(&counts, sizeof counts, 0);
  head.hash = XXH64(&head, format::hashed_head, 0);
  std::memcpy(bytes.data(), &head, sizeof head);
  for (std::size_t i = 0; i < format::section_count; ++i) {
    if (counts[i] > bytes.size()) return;
  }
  const format::Places places(counts);
  if (places.file_size() != bytes.size()) return;
  const std::uint64_t end = places.at[format::checksums];
  for (std::uint64_t i = 0; i < counts[format::checksums] && i * GuardedMap::block_size < end; ++i) {
    const std::uint64_t first = i * GuardedMap::block_size;
    const std::uint64_t sum =
        XXH64(bytes.data() + first, std::min<std::uint64_t>(end - first, GuardedMap::block_size), 0);
    std::memcpy(bytes.data() + end + 8 * i, &sum, sizeof sum);
  }
}

}  // namespace cdfr
