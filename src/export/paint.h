/// The colours of a painted mesh, by vertex or by triangle.
#pragma once

#include <cstddef>

#include "cdfr/export/painted.h"

namespace cdfr {

/// Finds the array that is painted. The mesh must outlive it.
class Paint {
 public:
  /// Precondition: check_painted has passed.
  explicit Paint(const PaintedMesh& painted) noexcept;

  bool on(ArrayPlace place) const noexcept { return array_ != nullptr && array_->place == place; }
  bool any() const noexcept { return array_ != nullptr; }
  /// Precondition of both: any(), and i is a vertex or a triangle, as on() says.
  double value(std::size_t i) const noexcept { return array_->values[i]; }
  Colour colour(std::size_t i) const noexcept { return painted_colour(value(i), least_, greatest_); }

 private:
  const MeshArray* array_ = nullptr;
  double least_, greatest_;
};

/// All that write_painted says of arrays, range, balls and labels; not the mesh itself.
Result<void> check_painted(const PaintedMesh& painted);

/// "thickness from 2 (yellow) to 20 (dark blue) mm": what the colours mean, in one line. Precondition: any.
std::string range_text(const PaintedMesh& painted);

}  // namespace cdfr
