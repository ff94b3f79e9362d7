/// Solids swept by a profile, along a height or about an axis: closed forms, and triangle meshes of them.
///
/// How far a mesh is off its solid: in each cross-section chords stand for arcs. A chord is at most its
/// sagitta from its arc, and every point between the two lies on a line across of at most that length. So,
/// whether a point is inside both, outside both or between, its signed distances to mesh and solid differ by
/// at most the sagitta. A solid of revolution is approached in two such steps, profile and rings, of half the
/// chord error each: its quads are plane, so the mesh is just the second step's solid.
#pragma once

#include "analysis/profile.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

/// The profile's area times 0 <= z <= height.
struct Extrusion {
  Profile profile;
  double height = 0;

  double volume() const { return profile.area() * height; }
  double area() const { return 2 * profile.area() + profile.length() * height; }
  /// Of the product of two sets: the least of their depths. Exact inside; outside only the sign is.
  double depth(const Vec3& p) const;
  /// Patch 0 is the bottom, 1 the top, 2 what stands between them.
  Mesh mesh(double chord) const;
};

/// The profile's area in x >= 0 about the line x = 0, which becomes the z axis; y becomes z. A profile that
/// reaches the axis has one side on it, the last.
struct Revolution {
  Profile profile;

  double volume() const;
  double area() const;
  double depth(const Vec3& p) const;
  Mesh mesh(double chord) const;
};

}  // namespace cdfr::test
