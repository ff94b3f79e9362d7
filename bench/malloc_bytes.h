/// For peers that count no bytes themselves.
#pragma once

#include <malloc.h>

#include <cstddef>

namespace cdfr::bench {

/// What this program holds from malloc, mapped blocks included.
inline std::size_t malloc_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace cdfr::bench
