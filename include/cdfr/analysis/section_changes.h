/// The heavy sections of two revisions of a part, side by side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "cdfr/analysis/sections.h"
#include "cdfr/core/api.h"

namespace cdfr {

enum class SectionFate : std::uint8_t {
  same,   ///< neither volume nor ball differ by more than both errors
  grown,  ///< more volume; or as much, and a larger ball
  shrunk,
  added,  ///< no former section matches
  gone    ///< no section of now matches
};

struct SectionChange {
  SectionFate fate = SectionFate::same;
  std::optional<std::size_t> now, former;  ///< places in the two lists
};

/// Pairs sections whose boxes, grown by both errors, overlap: those with the nearest ball centres first, each
/// section at most once. Changes come in the order of `now`, then what is gone in the order of `former`. Both
/// revisions have to lie in the same place. O(sections^2).
CDFR_API std::vector<SectionChange> section_changes(const Sections& now, const Sections& former);

}  // namespace cdfr
