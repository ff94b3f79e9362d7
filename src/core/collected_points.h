/// A sink that keeps what it is given.
#pragma once

#include <span>
#include <vector>

#include "cdfr/core/sinks.h"

namespace cdfr {

class CollectedPoints : public PointSink {
 public:
  Result<void> write(std::span<const ContourPoint> block) override {
    points.insert(points.end(), block.begin(), block.end());
    return {};
  }

  std::vector<ContourPoint> points;
};

}  // namespace cdfr
