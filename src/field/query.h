/// The triangle closest to a point, and all that belongs to it.
#pragma once

#include <optional>

#include "cdfr/field/field.h"
#include "field/field_data.h"
#include "field/race.h"
#include "octree/scan.h"

namespace cdfr {

/// Largest coordinate of p and the mesh.
double size_of(const FieldData& field, const Vec3& p) noexcept;

/// A point as the kernel sees it.
struct Query {
  Vec3 p;
  double scale = 1;  ///< of the true distance to the kernel's
};

/// Precondition: x is finite.
Query admitted(const FieldData& field, const Vec3& x) noexcept;

/// In the leaf that p is in: among what a scan has left of its list, or, where that is not complete, in all
/// of it.
Finding closest_in_leaf(const FieldData& field, const Vec3& p, const Located& leaf,
                        const Candidates& candidates) noexcept;

/// By the leaf's list in the domain, by the BVH beyond. Precondition: p is finite, within largest_query,
/// without dust.
Finding find_closest(const FieldData& field, const Vec3& p) noexcept;

/// By every triangle, without a tree.
Finding find_closest_brute(const FieldData& field, const Vec3& p) noexcept;

enum class Finder { tree, brute };

/// What a leaf of that side tells of the sign: the signed distance, or nothing.
std::optional<double> signed_by_leaf(const FieldData& field, Side side, double distance) noexcept;
double signed_distance(const FieldData& field, const Query& query, const Finding& finding) noexcept;
double signed_distance(const FieldData& field, const Vec3& x) noexcept;
double unsigned_distance(const FieldData& field, const Vec3& x) noexcept;
Closest closest_point(const FieldData& field, const Query& query, const Finding& finding) noexcept;
Closest closest_point(const FieldData& field, const Vec3& x, Finder finder) noexcept;

}  // namespace cdfr
