#include "parts/prism.h"

namespace cdfr {

void add_wall(Mesh& mesh, std::uint32_t low, std::uint32_t high, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({low + i, low + next, high + next});
    mesh.triangles.push_back({low + i, high + next, high + i});
  }
}

}  // namespace cdfr
