/// Where the contour crosses minimal edges: vertices of the mesh that lie on grid lines exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "contour/corner_values.h"
#include "contour/sought.h"
#include "core/progress.h"

namespace cdfr {

struct Crossing {
  Vec3 position;      ///< strictly between the edge's ends; two coordinates are the grid's
  Vec3 gradient;      ///< of the signed distance
  double excess = 0;  ///< signed distance minus the one sought
};

/// A vertex stays off the ends of its edge, the border of its face and of its cell by this share of the edge.
inline constexpr double hair_share = 0x1p-20;

class Crossings {
 public:
  Crossings(const Sought& sought, const CornerValues& corners) : sought_(sought), corners_(corners) {}

  /// Of the edge along `axis` between two corners, of which the set holds one: a number that stays the
  /// edge's.
  std::uint32_t add(int axis, std::uint32_t low, std::uint32_t high);
  /// Is the edge of the first one a part of that of the second, on one line?
  bool lies_in(std::uint32_t part, std::uint32_t whole) const noexcept;
  /// Finds those that are new: by the line through the values at the ends, then by tangents and halving.
  /// False if cancelled.
  bool solve(Progress& progress);

  const Crossing& operator[](std::uint32_t number) const noexcept { return crossings_[number]; }
  std::size_t size() const noexcept { return crossings_.size(); }
  std::uint64_t evaluations() const noexcept { return evaluations_; }

 private:
  struct Edge {
    int axis;
    std::uint32_t low, high;
  };
  /// The crossing lies between the shares `from` and `to` of the edge.
  struct Bracket {
    std::uint32_t number;
    double from = 0, to = 1;
    double at_from = 0, at_to = 0;  ///< signed distances, minus the one sought
    double share = 0;
  };

  Vec3 place(const Edge& edge, double share) const noexcept;
  bool improve(Bracket& bracket, const Closest& closest, int round) noexcept;

  const Sought& sought_;
  const CornerValues& corners_;
  std::vector<Edge> edges_;
  std::vector<Crossing> crossings_;  ///< as many as are solved
  std::uint64_t evaluations_ = 0;
};

}  // namespace cdfr
