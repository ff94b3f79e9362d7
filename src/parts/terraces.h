/// Solids with flat floors and upright walls, in as few triangles as their corners allow.
#pragma once

#include <span>

#include "cdfr/mesh/mesh.h"
#include "parts/recipe.h"

namespace cdfr {

/// The border of what the steps leave solid, in the recipe's lengths divided by `scale`: a recipe in tenths
/// gives the doubles nearest to its decimals. At most 64 layers.
///
/// Preconditions: two outlines are the same, apart or one in the other, and do not touch; where one ends at a
/// height, the plan beside it does not change from void to solid while it changes from solid to void.
///
/// Every corner is the end of a wall. So a wall of n sides from one height to another brings 2 n corners, and
/// as a closed surface of V corners with g holes through it (its genus) has 2 V - 4 + 4 g triangles by
/// Euler's formula, one in one piece has 4 (n + ... + n + g - 1), over all walls.
Mesh build_terraces(std::span<const Step> steps, double scale);

}  // namespace cdfr
