/// Proof that a contour does not enter a box, sharper than the slope of 1 that every distance has.
#pragma once

#include <array>

#include "cdfr/core/types.h"
#include "field/field_data.h"

namespace cdfr {

/// An upper bound on the distance over the box [lo, lo + size]^3.
///
/// For one triangle T the distance d(P,T) is convex in P, so on a box it is at most the multilinear
/// interpolation of its values at the corners (apply convexity along one axis after another). The distance to
/// the surface is at most d(P,T_i) for each i of any few triangles, hence at most any mean sum_i m_i d(P,T_i)
/// with weights of sum 1, which is interpolated from the corners' means. So
///     max over the box of d  <=  max over corners C of  sum_i m_i d(C,T_i).
/// With one triangle this is the bound of DESIGN promise 5. With two, half and half, it is exact between
/// parallel walls, where one triangle alone is off by half the box. The triangles are the base triangles of
/// the corners and the centre; tried are each alone, each pair and all together; the least bound counts.
double distance_above(const FieldData& field, const Vec3& lo, double size) noexcept;

}  // namespace cdfr
