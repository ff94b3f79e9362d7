/// The caller's tick, called from whichever worker comes by, one at a time.
#pragma once

#include <atomic>
#include <mutex>

#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "core/guarded_map.h"

namespace cdfr {

/// Counts steps of a known total within a share of the whole task and carries the cancel flag.
class Progress {
 public:
  explicit Progress(const Run& run) noexcept : run_(run) {}

  /// From now on the work ends, as if it were cancelled, when the file that it reads has failed: what it reads then
  /// may lead it anywhere.
  void watch(const GuardedMap* map) noexcept { map_ = map; }
  /// What follows is `steps` steps that take the task from `from` to `to`.
  void phase(double from, double to, double steps) noexcept {
    from_ = from;
    each_ = steps > 0 ? (to - from) / steps : 0;
    done_ = 0;
  }
  void step() noexcept {
    done_.fetch_add(1, std::memory_order_relaxed);
    poll();
  }
  /// Lets the caller cancel inside a long step. False if it did.
  bool poll() noexcept {
    if (map_ != nullptr && map_->failed()) cancelled_ = true;
    if (run_.tick != nullptr && !cancelled()) {
      const std::unique_lock lock(mutex_, std::try_to_lock);
      const double done = from_ + each_ * static_cast<double>(done_.load(std::memory_order_relaxed));
      if (lock.owns_lock() && !run_.tick(run_.context, done)) cancelled_ = true;
    }
    return !cancelled();
  }
  bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }
  static Error error() { return {Code::cancelled, 0, "cancelled"}; }

 private:
  const Run& run_;
  const GuardedMap* map_ = nullptr;
  double from_ = 0, each_ = 0;
  std::atomic<std::uint64_t> done_{0};
  std::atomic<bool> cancelled_{false};
  std::mutex mutex_;
};

}  // namespace cdfr
