/// Tables 5 to 7 of papers/huang-2001: contours from fields of two resolutions, at three tolerances.
#pragma once

#include "tables/csv.h"
#include "tables/subjects.h"

namespace cdfr::bench {

/// Each contour from the uniform field, and from octrees by the papers' rule and by cdfr's own. All by one
/// thread.
Csv contour_table(const std::vector<ContourCase>& cases);

}  // namespace cdfr::bench
