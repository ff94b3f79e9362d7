/// The merge tree of depth: which deep places there are, and how deep the necks between them.
///
/// As a level sinks from the deepest point to the floor, {depth > level} gains a component at each local
/// maximum, and two become one at each neck. Both happen at critical points alone, so the tree is one over
/// the critical cells: the cores of those that touch are joined by the straight way between them, and each
/// core at the border of a cluster with the one that the way up from beside it ends in (ascent.h). Links are
/// followed deepest first and components kept by union-find; of two that meet, the shallower one ends and its
/// maximum's prominence is its depth above the neck (the elder rule, Edelsbrunner, Letscher, Zomorodian
/// 2002).
///
/// **What is certain.** Every maximum deeper than the floor lies in a critical cell, whose core is no more
/// than error / 2 shallower. A link is a way whose depth is known along all of it (way_depth): a neck is at
/// least as deep as stated. That no better way was missed rests on those that start beside the clusters'
/// cells, one a side.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/critical_cells.h"
#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

/// A local maximum: cells are numbers in CriticalCells.
struct DepthPeak {
  static constexpr std::size_t none = ~std::size_t{0};

  std::size_t cell = 0;      ///< its deepest
  std::size_t elder = none;  ///< deepest cell of the peak that it meets; none for the deepest of its body
  Vec3 neck;                 ///< where
  double neck_depth = 0;     ///< 0 if it meets none
  bool fed = false;          ///< some way leads to a touched cell
  Vec3 feed;                 ///< the least deep place on the best of them
  double feed_depth = 0;
};

/// Two cells that a way joins, nowhere less deep than `depth`, which it is at `place`.
struct DepthLink {
  std::size_t from = 0, to = 0;
  double depth = 0;
  Vec3 place;
};

/// Of cells that touch, and up from beside cells where there is none. Runs in the caller's task arena.
std::vector<DepthLink> depth_links(const FieldData& field, const CriticalCells& critical, double floor,
                                   Progress& progress);

/// Peaks of prominence above `prominence`, the deepest first, ties in Morton order. O(n log n).
std::vector<DepthPeak> depth_tree(const CriticalCells& critical, std::vector<DepthLink> links,
                                  double prominence);

}  // namespace cdfr
