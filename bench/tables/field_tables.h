/// Tables 1 to 4 of papers/huang-2001: parts, and what their fields hold and take.
#pragma once

#include "tables/csv.h"
#include "tables/subjects.h"

namespace cdfr::bench {

Csv part_table();

/// Rows of tables 2, 3 or 4, each in all ways. Columns that end in `_ms` or `_mb` depend on the machine, all
/// others do not. With `rounds` 0 nothing is timed.
Csv field_table(const std::vector<FieldCase>& cases, int rounds);

}  // namespace cdfr::bench
