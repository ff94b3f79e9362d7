/// The triangles that can be closest to a point of a cell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plain_foot.h"
#include "field/field_data.h"

namespace cdfr {

struct NearTriangle {
  std::uint32_t slot = 0;
  PlainFoot foot;  ///< of the cell's centre
};

/// More than this is not worth looking at: the cell is split first.
inline constexpr std::size_t most_near = 4096;

/// Triangles that may win in a cell of that centre and half diagonal r: those within d + 2 r of the centre, d
/// the distance there. For x in the cell d(x) <= d + r, and a triangle that wins at x is at most d(x) + r
/// from the centre. Of these a triangle leaves again if its tangent at the centre, a lower bound as distances
/// to convex sets are convex, is at all corners above the distance to the closest one's foot (corner
/// dominance, octree/influence.h). Among `candidates`, which include all that may win, or in the whole mesh.
/// False if there are more than most_near.
bool near_triangles(const FieldData& field, const Eigen::Vector3d& centre, double size,
                    std::span<const std::uint32_t> candidates, std::vector<NearTriangle>& near);
bool near_triangles(const FieldData& field, const Eigen::Vector3d& centre, double size, double distance,
                    std::vector<NearTriangle>& near);

}  // namespace cdfr
