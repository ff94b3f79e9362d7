/// Branch and bound for the deepest point of some cubes (Land and Doig 1960).
#pragma once

#include <cstdint>
#include <limits>
#include <queue>
#include <span>
#include <vector>

#include "cdfr/field/field.h"
#include "core/progress.h"
#include "field/field_data.h"
#include "geometry/cube.h"

namespace cdfr {

/// A cube of edge s and centre c has no point deeper than
///  - the depth of c and sqrt(3)/2 s, since the distance has slope 1, or
///  - distance_above's bound, which is exact between parallel walls, where the slope alone would leave all
///    cubes of a plate's middle plane to the end.
/// The cube with about the largest bound is halved next, until none exceeds the deepest centre by more than
/// `error`. Where the mesh is open the sign jumps off the surface, so there bounds are of the unsigned
/// distance.
class DeepestSearch {
 public:
  /// What is looked for.
  struct Goal {
    double error = 0;  ///< no point is deeper than what is found by more
    double above = 0;  ///< only what is deeper than that
    bool any = false;  ///< the first such point ends the search
    std::uint64_t most = std::numeric_limits<std::uint64_t>::max();  ///< cubes to halve
  };
  /// A cube whose centre was looked at.
  struct Looked {
    Cube cube;
    double bound = 0;          ///< no point of it is deeper
    double depth = 0;          ///< of the centre; not above 0 outside
    std::uint64_t number = 0;  ///< in the order they came up
    double rank = 0;           ///< the bound in whole errors
    /// Of a heap: the largest rank on top, of those the smallest cube. Along a plate's middle all bounds are
    /// the same but for rounding; one has to be looked into to the end before the others.
    friend bool operator<(const Looked& a, const Looked& b) noexcept {
      if (a.rank != b.rank) return a.rank < b.rank;
      return a.cube.size != b.cube.size ? a.cube.size > b.cube.size : a.number > b.number;
    }
  };

  /// Precondition: the field is signed.
  DeepestSearch(const FieldData& field, const Goal& goal, Progress& progress);

  /// Any number at a time.
  Looked look(const Cube& cube) const noexcept;
  /// Of nothing but what is deeper than Goal::above: its depth if there is none. `is_open` then says that the
  /// search ended at Goal::most.
  Deepest run(std::span<const Looked> cubes);
  bool is_open() const noexcept { return is_open_; }

 private:
  void better(const Looked& looked);
  void keep(Looked at);
  void close(const Looked& at) noexcept;
  void halve(const Looked& at);
  bool is_done() const noexcept;

  const FieldData& field_;
  Goal goal_;
  Progress& progress_;
  double rounding_;
  Deepest best_;
  std::priority_queue<Looked> open_;
  std::uint64_t next_ = 0, halved_ = 0;
  double closed_ = 0;  ///< largest bound of a cube that is not looked into any more
  bool is_open_ = false;
};

}  // namespace cdfr
