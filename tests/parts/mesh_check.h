/// What makes a mesh a solid, counted the plain way, apart from the library's own audit.
#pragma once

#include <cstddef>

#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

struct MeshCheck {
  std::size_t lone_edges = 0;      ///< directed edges without the opposite one
  std::size_t repeated_edges = 0;  ///< directed edges that occur twice
  std::size_t pinched = 0;         ///< vertices with more than one fan
  std::size_t unused = 0;          ///< vertices without triangles
  std::size_t twins = 0;           ///< vertices with the coordinates of another one
  std::size_t components = 0;
  double smallest_area = 0;
  double volume = 0;
  Box box;
};

MeshCheck check_mesh(const Mesh& mesh);

}  // namespace cdfr::test
