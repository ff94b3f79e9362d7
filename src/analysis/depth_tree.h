/// The merge tree of depth: which deep places there are, and how deep the necks between them.
///
/// As a level sinks from the deepest point to the floor, {depth > level} gains a component at each local
/// maximum, and two become one at each neck. Both happen at critical points alone, so the tree is one over
/// the critical cells: neighbours are joined, and so is each cell at the border of a cluster with the one
/// that the way up from there ends in (ascent.h). Components are kept by union-find; of two that meet, the
/// shallower one ends and its maximum's prominence is its depth above the neck (the elder rule, Edelsbrunner,
/// Letscher, Zomorodian 2002).
///
/// **What is certain.** Cells have half a diagonal of at most error / 2, so every maximum deeper than the
/// floor lies in a critical cell, whose centre is no more than error / 2 shallower. A join is a path whose
/// depth is known along it: the neck is at least as deep as stated, less the error. That no better path was
/// missed rests on the ways up that start at the clusters' borders, one a cell's side.
#pragma once

#include <cstddef>
#include <cstdint>
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
  std::size_t neck = none;   ///< cell through which it meets a deeper one; none of the deepest of its body
  std::size_t elder = none;  ///< deepest cell of the peak that it meets there
  std::size_t feed = none;   ///< cell of the least deep place on the best way to a touched cell
};

/// Two cells that a path joins, no shallower than `depth`.
struct DepthLink {
  std::size_t from = 0, to = 0;
  double depth = 0;
};

/// Ways up from the sides of critical cells beside which there is none. Runs in the caller's task arena.
std::vector<DepthLink> links_up(const FieldData& field, const CriticalCells& critical, double floor,
                                Progress& progress);

/// Peaks of prominence above `prominence`, the deepest first, ties by key. O(n log n).
std::vector<DepthPeak> depth_tree(const CriticalCells& critical, std::span<const DepthLink> links,
                                  double prominence);

}  // namespace cdfr
