/// Threads, progress and cancel of one piece of work.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "cdfr/core/run.h"
#include "interrupt.h"
#include "settings.h"

namespace cdfr::command {

/// What a signal does meanwhile.
enum class OnSignal {
  cancel,  ///< the work, through run()
  end,     ///< the program, at once: for work that leaves nothing half-written wherever it is
};

/// While it lives, progress is drawn on standard error if that is a terminal.
class Steering {
 public:
  Steering(const Settings& settings, std::string what, OnSignal on_signal = OnSignal::cancel);
  ~Steering();
  Steering(const Steering&) = delete;
  Steering& operator=(const Steering&) = delete;

  /// Valid as long as this lives.
  Run run() noexcept { return {threads_, tick, this}; }
  /// What follows takes the work from `from` to `to`, of 0 to 1.
  void share(double from, double to) noexcept;

 private:
  static bool tick(void* steering, double done) noexcept;
  void draw(double done) noexcept;

  std::optional<DeferInterrupts> defer_;
  unsigned threads_;
  std::string what_;
  bool drawing_;
  double from_ = 0, to_ = 1;
  int drawn_ = -1;  ///< percent
  std::chrono::steady_clock::time_point next_draw_;
};

}  // namespace cdfr::command
