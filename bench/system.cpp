#include "system.h"

#include <algorithm>

namespace cdfr::bench {

void System::batch(std::span<const Vec3> points, std::span<double> out, unsigned) const {
  singles(points, out);
}

void System::planes(const SampleGrid& grid, std::size_t first, std::size_t count, std::span<double> out,
                    unsigned threads) const {
  // A few planes at a time, so that the points are not another hundred megabytes to read.
  constexpr std::size_t slab = 4;
  for (std::size_t done = 0; done < count; done += slab) {
    const std::vector<Vec3> points = grid.planes(first + done, std::min(slab, count - done));
    batch(points, out.subspan(done * grid.plane_points(), points.size()), threads);
  }
}

std::vector<SystemKind> peer_kinds() {
  return {
#ifdef CDFR_BENCH_EMBREE
      {"embree", build_embree},
#endif
#ifdef CDFR_BENCH_CGAL
      {"cgal", build_cgal},
#endif
  };
}

std::vector<SystemKind> system_kinds() {
  std::vector<SystemKind> kinds = peer_kinds();
  kinds.insert(kinds.begin(), {"cdfr", build_cdfr});
  return kinds;
}

}  // namespace cdfr::bench
