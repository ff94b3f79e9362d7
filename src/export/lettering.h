/// Strokes of text as triangles in the plane z = constant, read from +z: where a viewer stands at first.
#pragma once

#include <string_view>
#include <vector>

#include "export/frame.h"
#include "export/glb_format.h"
#include "export/glb_scene.h"

namespace cdfr {

/// Capitals of all text, as a share of the drawing's diagonal.
inline constexpr double letter_share = 1.0 / 40;

class Lettering {
 public:
  Lettering(double height, double z) noexcept : height_(height), z_(z) {}

  /// The base line begins at (x, y).
  void write(std::string_view text, double x, double y);
  void line(double x0, double y0, double x1, double y1);
  /// Three a triangle; empty if nothing but blanks was written.
  const std::vector<glb::Float3>& corners() const noexcept { return corners_; }
  double width(std::string_view text) const noexcept;

 private:
  double height_, z_;
  std::vector<glb::Float3> corners_;
};

/// Ink: flat, of the grey that stands out as well from white as from black.
int add_ink(GlbScene& scene);

}  // namespace cdfr
