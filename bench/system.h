/// The engines that bench/peers compares, behind one face.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/core/types.h"
#include "cdfr/mesh/mesh.h"
#include "cdfr/octree/options.h"
#include "sample_grid.h"

namespace cdfr::bench {

/// A mesh made ready for queries. cdfr's distances are signed, those of the peers are not.
class System {
 public:
  virtual ~System() = default;
  virtual std::size_t bytes() const = 0;
  /// One call a point, one after another, as a program does that needs each answer before it goes on.
  virtual void singles(std::span<const Vec3> points, std::span<double> out) const = 0;
  /// All at once. Who has no such form answers one by one, on one thread.
  virtual void batch(std::span<const Vec3> points, std::span<double> out, unsigned threads) const;
  /// All points of a grid, in its order.
  virtual void fill(const SampleGrid& grid, std::span<double> out, unsigned threads) const;
};

struct SystemKind {
  const char* name;
  Result<std::unique_ptr<System>> (*build)(const Mesh& mesh, unsigned threads);
};

Result<std::unique_ptr<System>> build_cdfr(const Mesh& mesh, const BuildOptions& options, unsigned threads);
/// With the default options.
Result<std::unique_ptr<System>> build_cdfr(const Mesh& mesh, unsigned threads);
Result<std::unique_ptr<System>> build_embree(const Mesh& mesh, unsigned threads);
Result<std::unique_ptr<System>> build_cgal(const Mesh& mesh, unsigned threads);
Result<std::unique_ptr<System>> build_fcpw(const Mesh& mesh, unsigned threads);

/// The peers that were found when this was built.
std::vector<SystemKind> peer_kinds();
/// cdfr first, then the peers.
std::vector<SystemKind> system_kinds();

}  // namespace cdfr::bench
