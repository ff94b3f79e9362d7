/// What a packed file was made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cdfr/core/result.h"
#include "core/scratch.h"
#include "store/format.h"

namespace cdfr {

/// So that sections lie as they must.
struct alignas(format::alignment) Aligned {
  std::byte bytes[format::alignment];
};

/// `size` is what the head says. Errors: file_truncated, file_format with the byte.
Result<Large<Aligned>> unpacked(std::span<const std::byte> packed, std::uint64_t size);

}  // namespace cdfr
