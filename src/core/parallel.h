/// Work on a given number of threads, whose results never depend on that number.
#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <optional>

#include "cdfr/core/run.h"

namespace cdfr {

/// Calls work() with that many workers for every parallel loop inside. More than the machine has cores are
/// allowed for as long as the call lasts: oneTBB's own limit would hold them back.
template <class Work>
void with_threads(const Run& run, Work work) {
  std::optional<tbb::global_control> more;
  if (run.threads > static_cast<unsigned>(tbb::info::default_concurrency())) {
    more.emplace(tbb::global_control::max_allowed_parallelism, run.threads);
  }
  tbb::task_arena arena(run.threads == 0 ? tbb::task_arena::automatic : static_cast<int>(run.threads));
  arena.execute(work);
}

/// f(first, end) over fixed chunks of 0 .. count - 1. The chunks depend on `count` and `chunk` alone.
template <class Work>
void for_chunks(std::size_t count, std::size_t chunk, Work work) {
  tbb::parallel_for(std::size_t{0}, (count + chunk - 1) / chunk,
                    [&](std::size_t i) { work(i * chunk, std::min((i + 1) * chunk, count)); });
}

}  // namespace cdfr
