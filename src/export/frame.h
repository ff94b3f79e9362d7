/// Where a drawing lies, so that float32 can hold it.
#pragma once

#include "cdfr/core/types.h"
#include "cdfr/export/painted.h"
#include "export/glb_format.h"

namespace cdfr {

/// Coordinates relative to the middle of all that is drawn, in units of its size: between -2 and 2, whatever
/// the mesh's own unit and place are. float32 resolves 2^-23 of the drawing there.
class Frame {
 public:
  explicit Frame(const PaintedMesh& painted) noexcept;

  bool empty() const noexcept { return !(box_.lo.x <= box_.hi.x); }
  const Vec3& centre() const noexcept { return centre_; }
  double size() const noexcept { return size_; }  ///< a power of two, in the mesh's unit
  Vec3 inside(Vec3 p) const noexcept {
    return {(p.x - centre_.x) / size_, (p.y - centre_.y) / size_, (p.z - centre_.z) / size_};
  }
  glb::Float3 rounded(Vec3 p) const noexcept {
    const Vec3 q = inside(p);
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }
  /// Of all that is drawn, in this frame. Precondition of both: not empty.
  Box box() const noexcept { return {inside(box_.lo), inside(box_.hi)}; }
  double diagonal() const noexcept;  ///< of the box; 1 if it is a point

 private:
  Box box_;
  Vec3 centre_;
  double size_ = 1;
};

}  // namespace cdfr
