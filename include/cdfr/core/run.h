/// How work is steered: threads, progress and cancel come in by argument; there is no global state.
#pragma once

namespace cdfr {

struct Run {
  /// Worker threads; 0 takes what the machine has. Results never depend on it.
  unsigned threads = 0;
  /// Called now and then with the share done, 0 to 1; returning false cancels: the call ends soon with
  /// Code::cancelled and leaves nothing half-written. May be called from any worker, never from two at once.
  bool (*tick)(void* context, double done) noexcept = nullptr;
  void* context = nullptr;
};

}  // namespace cdfr
