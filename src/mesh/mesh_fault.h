/// What the engine refuses in a mesh before it does anything with it.
#pragma once

#include <optional>
#include <string>

#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"
#include "mesh/coordinate.h"

namespace cdfr {

/// The first fault, with its place: empty_mesh, out_of_range, bad_index, not_finite.
inline std::optional<Error> mesh_fault(const MeshView& mesh) {
  if (mesh.triangles.empty()) return Error{Code::empty_mesh, 0, "mesh has no triangles"};
  if (mesh.triangles.size() >= no_index || mesh.vertices.size() >= no_index) {
    return Error{Code::out_of_range, 0, "mesh has more than 2^32 - 2 triangles or vertices"};
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t corner : mesh.triangles[t]) {
      if (corner < mesh.vertices.size()) continue;
      return Error{Code::bad_index, t,
                   "triangle " + std::to_string(t) + " has index " + std::to_string(corner) +
                       ", vertices are " + std::to_string(mesh.vertices.size())};
    }
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const auto wrong = coordinate_fault(mesh.vertices[i]);
    if (wrong) return Error{*wrong, i, "vertex " + std::to_string(i) + " " + coordinate_fault_text(*wrong)};
  }
  return std::nullopt;
}

}  // namespace cdfr
