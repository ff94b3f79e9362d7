#include "contour/cell_curves.h"

#include <algorithm>

namespace cdfr {
namespace {

struct FaceCurve {
  FacePieces pieces;
  CellFace face;
};

FaceCurve curve_of(const MinimalFace& face, const SurfaceLeaf& owner) noexcept {
  FaceCurve curve{{}, cell_face(face.axis, face.of_above ? 0 : 1)};
  std::array<bool, 4> held{};
  for (std::size_t k = 0; k < 4; ++k) held[k] = (owner.held >> curve.face.corners[k] & 1U) != 0;
  curve.pieces = face_pieces(held);
  return curve;
}

}  // namespace

void CellCurves::collect(std::span<const MinimalFace> faces) {
  faces_.assign(faces.begin(), faces.end());
  first_.assign(leaves_.leaves().size() + 1, 0);
  const auto owner = [&](const MinimalFace& face) -> const SurfaceLeaf& {
    return leaves_.leaves()[face.of_above ? face.above : face.below];
  };
  std::erase_if(faces_, [&](MinimalFace& face) {
    face.pieces = static_cast<std::uint8_t>(curve_of(face, owner(face)).pieces.count);
    first_[face.below] += face.pieces;
    first_[face.above] += face.pieces;
    return face.pieces == 0;
  });
  std::uint32_t total = 0;
  for (std::uint32_t& first : first_) total += std::exchange(first, total);
  pieces_.resize(total);
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < faces_.size(); ++i) {
    const MinimalFace& face = faces_[i];
    const SurfaceLeaf& leaf = owner(face);
    const FaceCurve curve = curve_of(face, leaf);
    for (int k = 0; k < curve.pieces.count; ++k) {
      const std::uint32_t from = leaf.sides[curve.face.sides[curve.pieces.from[k]]];
      const std::uint32_t to = leaf.sides[curve.face.sides[curve.pieces.to[k]]];
      pieces_[next[face.below]++] = {from, to, i};
      pieces_[next[face.above]++] = {to, from, i};
    }
  }
}

void CellCurves::loops(std::uint32_t leaf, std::vector<std::uint32_t>& starts) {
  const std::span<CurvePiece> pieces =
      std::span(pieces_).subspan(first_[leaf], first_[leaf + 1] - first_[leaf]);
  starts.assign(1, 0);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    // pieces[begin .. i] are a path; close it or go on.
    if (pieces[i].to == pieces[begin].from) {
      begin = i + 1;
      starts.push_back(static_cast<std::uint32_t>(begin));
      continue;
    }
    for (std::size_t k = i + 1; k < pieces.size(); ++k) {
      if (pieces[k].from == pieces[i].to) {
        std::swap(pieces[i + 1], pieces[k]);
        break;
      }
    }
  }
}

}  // namespace cdfr
