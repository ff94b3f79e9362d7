/// Signed distances of many points, each with the few triangles that may be closest to it: their pairs meet
/// the kernel in lanes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "field/field_data.h"
#include "geometry/measured_lanes.h"

namespace cdfr {

class Contests {
 public:
  /// Most triangles in one contest.
  static constexpr std::size_t most = lane_count;

  Contests(const FieldData& field, std::span<double> out) noexcept : field_(field), out_(out) {}

  /// out[place] is to be the signed distance of p, which lies in a leaf of that side, as Race and
  /// signed_distance (query.h) have it. It may be set as late as in settle().
  void add(std::size_t place, const Vec3& p, Side side, std::span<const std::uint32_t> slots) noexcept;
  void settle() noexcept;

 private:
  struct Contest {
    std::size_t place;
    std::uint32_t first, count;  ///< lanes
    Side side;
  };

  DoubleDouble squared(std::uint32_t lane) const noexcept {
    return {measured_.squared[lane], measured_.squared_rest[lane]};
  }
  double distance_of(const Contest& contest) const noexcept;
  bool is_alone(const Contest& contest, std::uint32_t best) const noexcept;
  std::uint32_t closest_lane(const Contest& contest) const noexcept;
  double race(const Vec3& p, Side side, std::span<const std::uint32_t> slots) const noexcept;

  const FieldData& field_;
  std::span<double> out_;
  std::size_t contest_count_ = 0;
  std::uint32_t used_ = 0;  ///< lanes
  std::array<Contest, lane_count> contests_;
  std::array<std::uint32_t, lane_count> slots_;
  PairLanes pairs_;
  MeasuredLanes measured_;
};

}  // namespace cdfr
