/// Work on a given number of threads, whose results never depend on that number.
#pragma once

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#include "cdfr/core/run.h"

namespace cdfr {

/// Calls work() with that many workers, at most as many as the machine has, for every parallel loop inside.
template <class Work>
void with_threads(const Run& run, Work work) {
  // TBB has no more workers than that, and complains on standard error when asked for them.
  const auto most = static_cast<unsigned>(tbb::info::default_concurrency());
  const auto threads = static_cast<int>(std::min(run.threads, most));
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
  arena.execute(work);
}

/// f(first, end) over fixed chunks of 0 .. count - 1. The chunks depend on `count` and `chunk` alone.
template <class Work>
void for_chunks(std::size_t count, std::size_t chunk, Work work) {
  tbb::parallel_for(std::size_t{0}, (count + chunk - 1) / chunk,
                    [&](std::size_t i) { work(i * chunk, std::min((i + 1) * chunk, count)); });
}

}  // namespace cdfr
