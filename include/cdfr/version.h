/// Version of cdfr: the macros speak for the headers, the function for the linked library.
#pragma once

#include "cdfr/core/api.h"

#define CDFR_VERSION_MAJOR 0
#define CDFR_VERSION_MINOR 1
#define CDFR_VERSION_PATCH 0

namespace cdfr {

/// "major.minor.patch" of the library that was linked. Never null; thread safe.
CDFR_API const char* version() noexcept;

}  // namespace cdfr
