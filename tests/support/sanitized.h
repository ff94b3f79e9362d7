/// Under sanitizers code takes ten times as long: tests that only repeat themselves do less there.
#pragma once

namespace cdfr::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace cdfr::test
