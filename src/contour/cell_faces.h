/// Corners, sides and faces of a cube, and the curves that signs at corners draw on it.
///
/// Corner bits: 1 is x, 2 y, 4 z. A side runs along `axis`; with u = axis + 1 and w = axis + 2 (mod 3) it
/// lies at the high end of u or w where that bit is set. A face is seen against its axis, b = axis + 1 to the
/// right, c = axis + 2 up: corner k of its four and side k, from corner k to corner k + 1, follow
/// counter-clockwise.
#pragma once

#include <array>
#include <cstdint>

namespace cdfr {

inline constexpr int cell_sides = 12;

constexpr int side_number(int axis, int u_bit, int w_bit) noexcept { return axis * 4 + u_bit + 2 * w_bit; }
constexpr int side_axis(int side) noexcept { return side / 4; }
/// Its corner at the low end; the other one has the axis's bit too.
constexpr int side_corner(int side) noexcept {
  const int axis = side / 4;
  return (side & 1) << (axis + 1) % 3 | (side >> 1 & 1) << (axis + 2) % 3;
}

struct CellFace {
  std::array<int, 4> corners, sides;
};

constexpr CellFace cell_face(int axis, int high) noexcept {
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  const int base = high << axis, right = 1 << b, up = 1 << c;
  return {
      {base, base | right, base | right | up, base | up},
      {side_number(b, 0, high), side_number(c, high, 1), side_number(b, 1, high), side_number(c, high, 0)}};
}

/// Pieces of curve on a face: from side `from[i]` to side `to[i]` (0 to 3) of it. Seen as above, what the set
/// does not hold is to the left. Each run of held corners is cut off by itself: where the signs are
/// ambiguous, equal ones that are held stay apart, which both cells of the face decide alike.
struct FacePieces {
  int count = 0;
  std::array<int, 2> from{}, to{};
};

constexpr FacePieces face_pieces(const std::array<bool, 4>& held) noexcept {
  FacePieces pieces;
  for (int k = 0; k < 4; ++k) {
    if (held[k] || !held[(k + 1) % 4]) continue;
    int m = (k + 1) % 4;
    while (held[(m + 1) % 4]) m = (m + 1) % 4;
    pieces.from[pieces.count] = k;
    pieces.to[pieces.count++] = m;
  }
  return pieces;
}

/// Curves on the boundary of a cell by its corners' signs, where no neighbour is finer.
struct SignCase {
  int loops = 0;
  bool ambiguous = false;              ///< one of the faces is
  std::array<int, cell_sides> next{};  ///< side that the curve goes on to from a side, or -1
};

constexpr SignCase sign_case(unsigned held) noexcept {
  SignCase result;
  result.next.fill(-1);
  for (int axis = 0; axis < 3; ++axis) {
    for (int high = 0; high < 2; ++high) {
      const CellFace face = cell_face(axis, high);
      std::array<bool, 4> at{};
      for (int k = 0; k < 4; ++k) at[k] = (held >> face.corners[k] & 1U) != 0;
      const FacePieces pieces = face_pieces(at);
      result.ambiguous = result.ambiguous || pieces.count > 1;
      for (int i = 0; i < pieces.count; ++i) {
        const int from = face.sides[high ? pieces.from[i] : pieces.to[i]];
        result.next[from] = face.sides[high ? pieces.to[i] : pieces.from[i]];
      }
    }
  }
  std::array<bool, cell_sides> seen{};
  for (int side = 0; side < cell_sides; ++side) {
    if (result.next[side] < 0 || seen[side]) continue;
    ++result.loops;
    for (int at = side; !seen[at]; at = result.next[at]) seen[at] = true;
  }
  return result;
}

}  // namespace cdfr
