/// The painted mesh itself in a GLB: too large to be built in memory.
#pragma once

#include <cstdint>

#include "export/frame.h"
#include "export/glb_scene.h"
#include "export/paint.h"

namespace cdfr {

/// Numbers by vertex keep the mesh's vertices and indices; numbers by triangle give each triangle three of
/// its own. Vertices are interleaved: position, then colour and value if there is paint. Without normals
/// viewers shade each triangle flat, so the mesh is seen as it is.
class GlbPart {
 public:
  /// Both must outlive it.
  GlbPart(const PaintedMesh& painted, const Frame& frame) noexcept
      : painted_(painted), frame_(frame), paint_(painted) {}

  /// Without its JSON; a mesh without triangles takes none.
  std::uint64_t bytes() const noexcept { return vertices() * stride() + index_bytes(); }
  void declare(int material, GlbScene& scene) const;
  /// The views that declare() left for later.
  Result<void> write(WholeFile& file) const;

 private:
  bool empty() const noexcept { return painted_.mesh.triangles.empty(); }
  bool by_triangle() const noexcept { return paint_.on(ArrayPlace::face); }
  std::uint32_t stride() const noexcept { return paint_.any() ? 28 : 12; }
  std::uint64_t vertices() const noexcept;
  std::uint64_t index_bytes() const noexcept;
  Vec3 position(std::uint64_t i) const noexcept;
  Json positions(int view) const;
  Result<void> write_vertex(std::uint64_t i, std::span<const float, 256> linear, WholeFile& file) const;

  const PaintedMesh& painted_;
  const Frame& frame_;
  Paint paint_;
};

}  // namespace cdfr
