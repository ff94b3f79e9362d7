/// Signed distances of points whose closest feature is known before they meet the kernel: those of one
/// feature meet it together, a vector at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "field/contests.h"
#include "field/field_data.h"
#include "geometry/measured_lanes.h"
#include "octree/tile_scan.h"

namespace cdfr {

class FeatureRuns {
 public:
  /// Numbers of triangles are below this.
  static constexpr std::size_t most_numbers = TileList::most;

  /// Points that are too few for a run of their own go to `few`.
  FeatureRuns(const FieldData& field, std::span<double> out, Contests& few) noexcept
      : field_(field), out_(out), few_(few) {}

  /// Points that follow lie in leaves of that side, and triangles get numbers afresh.
  void begin(Side side) noexcept { side_ = side; }
  /// out[place] is to be the signed distance of p. The closest triangle is `slot`, with the foot at that
  /// place of it; `number` tells triangles apart. It may be set as late as in settle().
  void add(std::size_t place, const Vec3& p, std::uint32_t slot, std::size_t number,
           TrianglePlace foot) noexcept {
    if (count_ == waiting_.size()) settle();
    waiting_[count_++] = {p, place, slot, static_cast<std::uint16_t>(8 * number + foot)};
  }
  void settle() noexcept;

 private:
  struct Waiting {
    Vec3 p;
    std::size_t place;
    std::uint32_t slot;
    std::uint16_t feature;  ///< number and place on the triangle
  };
  using Members = std::span<const std::uint16_t>;

  void sort() noexcept;
  void run(Members members) noexcept;
  double distance_of(std::size_t lane, const Vec3& p, std::uint32_t slot,
                     const TriangleShape& shape) const noexcept;

  const FieldData& field_;
  std::span<double> out_;
  Contests& few_;
  Side side_ = Side::undecided;
  std::size_t count_ = 0;
  std::array<Waiting, 2048> waiting_;
  std::array<std::uint16_t, 2048> order_;  ///< by feature
  std::array<std::uint16_t, 8 * most_numbers + 1> ends_;
  MeasuredLanes measured_;
};

}  // namespace cdfr
