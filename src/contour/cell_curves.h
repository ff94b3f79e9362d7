/// The curves in which the mesh meets cells' boundaries: pieces on minimal faces, closed to loops cell by
/// cell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contour/crossings.h"
#include "contour/surface_leaves.h"

namespace cdfr {

/// A minimal face that the curve passes: the two leaves, the smaller one's whole face. `below` comes before
/// `above` on the axis.
struct MinimalFace {
  std::uint32_t below = 0, above = 0;  ///< leaves
  std::uint8_t axis = 0;
  std::uint8_t pieces = 0;
  bool of_above = false;  ///< whose face it is
};

/// From one crossing to another on a face, as seen from outside the cell with what is not held to the left.
struct CurvePiece {
  std::uint32_t from = 0, to = 0;
  std::uint32_t face = 0;
};

/// Pieces in the order of a loop.
using CurveLoop = std::span<const CurvePiece>;

class CellCurves {
 public:
  explicit CellCurves(const SurfaceLeaves& leaves) : leaves_(leaves) {}

  /// Anew from the leaves' crossings.
  void collect(std::span<const MinimalFace> faces);
  std::span<const MinimalFace> faces() const noexcept { return faces_; }
  /// Of a leaf; `starts` are where each begins, and where the last one ends. Sorts the leaf's pieces, which
  /// is done once: after collect() each leaf may be asked by one thread.
  void loops(std::uint32_t leaf, std::vector<std::uint32_t>& starts);
  /// After loops().
  std::span<const CurvePiece> pieces(std::uint32_t leaf) const noexcept {
    return std::span(pieces_).subspan(first_[leaf], first_[leaf + 1] - first_[leaf]);
  }

 private:
  const SurfaceLeaves& leaves_;
  std::vector<MinimalFace> faces_;
  std::vector<std::uint32_t> first_;  ///< of a leaf's pieces
  std::vector<CurvePiece> pieces_;
};

}  // namespace cdfr
