/// Points from CSV, line by line, so that a stream needs no more memory than its points.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/core/types.h"

namespace cdfr {

class CsvPoints {
 public:
  /// One line without its LF. The first that is not blank may be the header x,y,z,...
  Result<void> add_line(std::string_view line);
  std::vector<Vec3> take() && noexcept { return std::move(points_); }

 private:
  std::vector<Vec3> points_;
  std::uint64_t line_ = 0;
  bool before_first_ = true;
};

}  // namespace cdfr
