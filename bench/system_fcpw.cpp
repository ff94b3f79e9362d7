/// fcpw's bounding volume hierarchy in float, its vectorised form where its SIMD library is there too.
#include <fcpw/fcpw.h>

#include <vector>

#include "malloc_bytes.h"
#include "system.h"

namespace cdfr::bench {
namespace {

#ifdef FCPW_USE_ENOKI
constexpr bool vectorised = true;
#else
constexpr bool vectorised = false;
#endif

fcpw::Vector<3> in_float(const Vec3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

class FcpwSystem final : public System {
 public:
  explicit FcpwSystem(const Mesh& mesh) {
    const std::size_t before = malloc_bytes();
    std::vector<fcpw::Vector<3>> positions;
    positions.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) positions.push_back(in_float(v));
    std::vector<fcpw::Vector3i> corners;
    corners.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
      corners.emplace_back(static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2]));
    scene_.setObjectCount(1);
    scene_.setObjectVertices(positions, 0);
    scene_.setObjectTriangles(corners, 0);
    scene_.build(fcpw::AggregateType::Bvh_SurfaceArea, vectorised);
    bytes_ = malloc_bytes() - before;
  }

  std::size_t bytes() const override { return bytes_; }
  void singles(std::span<const Vec3> points, std::span<double> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      fcpw::Interaction<3> found;
      scene_.findClosestPoint(in_float(points[i]), found);
      out[i] = found.d;
    }
  }

 private:
  fcpw::Scene<3> scene_;
  std::size_t bytes_ = 0;
};

}  // namespace

Result<std::unique_ptr<System>> build_fcpw(const Mesh& mesh, unsigned) {
  return {std::make_unique<FcpwSystem>(mesh)};
}

}  // namespace cdfr::bench
