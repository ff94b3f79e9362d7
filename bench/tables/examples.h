/// The runs that the papers tell in their text: heavy parts, as an engineer would run them today.
#pragma once

#include "tables/csv.h"

namespace cdfr::bench {

/// Each in a process of its own, on one thread: the part made, its field built, its contour extracted.
/// Precondition: no other thread runs.
Csv example_table();

/// papers/huang-2001-report, section 6: the same engine by the papers' own field of resolution 300.
Csv uniform_engine_table();

}  // namespace cdfr::bench
