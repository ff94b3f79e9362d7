/// How many points a test takes of a model: CDFR_POINTS, a twentieth of it on more than 200,000 triangles;
/// without it a number small enough for every run of the suite.
#pragma once

#include <cstddef>

namespace cdfr::oracle {

std::size_t point_count(std::size_t triangles);

/// Too few points to spend long on building leaves for them.
bool short_run();

/// Fewer than 100 points asked for, as tools/test does under the sanitizers: what counts is that each branch
/// is taken, and tests that take long do so on less.
bool light_run();

}  // namespace cdfr::oracle
