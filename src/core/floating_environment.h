/// Holds the processor to IEEE double arithmetic, rounding to nearest, denormals kept, whatever the caller
/// has set.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#elif defined(__aarch64__)
#include <cstdint>
#endif

namespace cdfr {

/// Saves the caller's rounding mode and flush-to-zero, sets the default, restores at the end of the scope. A
/// few cycles where the caller's setting is the default already.
class FloatingEnvironment {
 public:
  FloatingEnvironment(const FloatingEnvironment&) = delete;
  FloatingEnvironment& operator=(const FloatingEnvironment&) = delete;

#if defined(__SSE2__)
  FloatingEnvironment() noexcept : saved_(_mm_getcsr()) {
    if ((saved_ & controls) != masked) _mm_setcsr((saved_ & ~controls) | masked);
  }
  ~FloatingEnvironment() {
    if ((saved_ & controls) != masked) _mm_setcsr(saved_);
  }

 private:
  /// Flush-to-zero, rounding, exception masks, denormals-are-zero.
  static constexpr unsigned controls = 0xffc0, masked = 0x1f80;
  unsigned saved_;
#elif defined(__aarch64__)
  FloatingEnvironment() noexcept {
    asm volatile("mrs %0, fpcr" : "=r"(saved_));
    if ((saved_ & controls) != 0) asm volatile("msr fpcr, %0" ::"r"(saved_ & ~controls));
  }
  ~FloatingEnvironment() {
    if ((saved_ & controls) != 0) asm volatile("msr fpcr, %0" ::"r"(saved_));
  }

 private:
  /// Flush-to-zero, default NaN and rounding mode.
  static constexpr std::uint64_t controls = 0x3c00000;
  std::uint64_t saved_;
#else
#error "cdfr knows how to hold the floating-point environment of x86-64 and arm64 only"
#endif
};

}  // namespace cdfr
