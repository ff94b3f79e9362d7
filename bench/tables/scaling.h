/// How fields grow: with resolution, and with triangles.
#pragma once

#include "tables/csv.h"

namespace cdfr::bench {

/// From 32 to 4096 finest cells a side. The uniform field stops where it is refused, an octree where its next
/// build would take longer than `most_seconds`.
Csv resolution_scaling(double most_seconds);

/// Made parts whose triangles are split into four, up to four times, and many heads in a row: 12 to 5 million
/// triangles, built as a caller builds them who gives no options.
Csv triangle_scaling();

/// Exponents of bytes and time, as least squares of their logarithms, for each part and way of the one table,
/// and for all parts of the other that have a thousand triangles and more.
Csv power_laws(const Csv& by_resolution, const Csv& by_triangles);

}  // namespace cdfr::bench
