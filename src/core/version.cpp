#include "cdfr/version.h"

#define CDFR_TEXT_OF(x) #x
#define CDFR_TEXT(x) CDFR_TEXT_OF(x)

namespace cdfr {

const char* version() noexcept {
  return CDFR_TEXT(CDFR_VERSION_MAJOR) "." CDFR_TEXT(CDFR_VERSION_MINOR) "." CDFR_TEXT(CDFR_VERSION_PATCH);
}

}  // namespace cdfr
