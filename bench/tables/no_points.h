/// A contour that is timed and not kept.
#pragma once

#include "cdfr/core/sinks.h"

namespace cdfr::bench {

class NoPoints final : public PointSink {
 public:
  Result<void> write(std::span<const ContourPoint>) override { return {}; }
};

}  // namespace cdfr::bench
