#include "cdfr/mesh/flip.h"

#include <utility>

namespace cdfr {

void flip(Mesh& mesh) noexcept {
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

}  // namespace cdfr
