/// SIGINT, SIGTERM and SIGHUP: end at once while nothing is at stake, else as soon as the work has cleaned
/// up. The third one ends the program in any case: a temporary file may then stay, a half-written target
/// never.
#pragma once

namespace cdfr::command {

/// Installs the handlers; a signal that the caller of the program had ignored stays ignored.
void catch_interrupts() noexcept;

/// The first signal that came in, or 0.
int received_signal() noexcept;

/// While one of these lives, a signal is only noted: whoever holds it looks at received_signal() and unwinds.
class DeferInterrupts {
 public:
  DeferInterrupts() noexcept;
  ~DeferInterrupts();
  DeferInterrupts(const DeferInterrupts&) = delete;
  DeferInterrupts& operator=(const DeferInterrupts&) = delete;
};

}  // namespace cdfr::command
