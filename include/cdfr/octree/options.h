/// What a caller may choose when a field is built.
#pragma once

#include <cstdint>

#include "cdfr/mesh/sign.h"

namespace cdfr {

/// Which triangles a leaf keeps.
enum class Lists : std::uint8_t {
  corner,  ///< corner dominance (src/octree/influence.h): the tight rule
  band,    ///< the source paper's range [m, m + sqrt(3) s]: for comparison
};

/// Where leaves have lists of their own. Everywhere else in the box, as beyond it, a query walks the BVH:
/// slower, and as exact.
enum class Domain {
  box,       ///< the mesh's box and its margin
  interior,  ///< where the surface or the inside comes in: the source paper's way
  band,      ///< within BuildOptions::band of the surface
};

struct BuildOptions {
  static constexpr int automatic_level = -1;

  /// Domain: the mesh's box grown by this share of its longest side. Queries beyond are exact too, and
  /// slower.
  double margin = 0.05;
  /// A cell with a longer list splits, if splitting pays. At least 1.
  int max_triangles_per_leaf = 320;
  /// About how many queries the field will answer. If it is not 0, max_triangles_per_leaf is chosen anew, so
  /// that the build and they take least: few queries get a field that is little more than a BVH. The default
  /// lists suit ten million. Answers never depend on it.
  std::uint64_t expected_queries = 0;
  /// Deepest level of a leaf, 0 to 18; level 0 cells are the cubes of the brick. Automatic: 5, and deeper for long
  /// and for fine parts, until a cell is about four triangles wide.
  int max_level = automatic_level;
  /// A split is kept if the children's mean list is at most this share of the parent's, and leaves are few
  /// enough: about 2048, and 0.3 a triangle with lists of 320, as many more with shorter ones as those are
  /// shorter to the power of 1.5. 1 keeps every split.
  double gain = 0.75;
  Sign sign = Sign::automatic;
  Lists lists = Lists::corner;
  /// Interior needs a sign.
  Domain domain = Domain::box;
  double band = 0;  ///< of Domain::band: positive, in the mesh's unit
};

}  // namespace cdfr
