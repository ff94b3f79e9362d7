/// Samples whose wall a design edge holds, and what is said of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/smooth_regions.h"
#include "cdfr/analysis/thickness.h"

namespace cdfr {

/// Sets opposed: a chord of the ball that turns by 120 degrees has sqrt(3)/2 of its diameter, and the facet
/// tolerance may have taken that much from it. Sets at_edge: where the opposite triangle's region adjoins the
/// sample's own at a design edge, or, for samples at vertices, such an edge ends there.
void mark_edge_samples(const TriangleStore& triangles, const SmoothRegions& regions,
                       std::span<const std::uint32_t> slots, SampleAt at, std::span<ThicknessSample> samples);

/// EdgePolicy::extrapolate: thickness, error and opposite of the nearest sample of the same region that is
/// not at an edge and has met something. Returns how many were set. O(n log n).
std::uint64_t extrapolate_edge_samples(const SmoothRegions& regions, std::span<const std::uint32_t> slots,
                                       std::span<ThicknessSample> samples);

}  // namespace cdfr
