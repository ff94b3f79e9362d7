#include "export/lettering.h"

#include <cmath>

#include "export/stroke_font.h"

namespace cdfr {
namespace {

/// Of a stroke, as a share of the height of capitals.
constexpr double thickness = 0.11;

}  // namespace

/// Half its own thickness longer at both ends, so that strokes that meet leave no notch.
void Lettering::line(double x0, double y0, double x1, double y1) {
  const double dx = x1 - x0, dy = y1 - y0;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (!(length > 0)) return;
  const double half = thickness / 2 * height_ / length;
  const double ax = half * dx, ay = half * dy;
  const auto corner = [&](double x, double y, double along, double across) -> glb::Float3 {
    return {static_cast<float>(x + along * ax - across * ay),
            static_cast<float>(y + along * ay + across * ax), static_cast<float>(z_)};
  };
  const glb::Float3 right0 = corner(x0, y0, -1, -1), left0 = corner(x0, y0, -1, 1);
  const glb::Float3 right1 = corner(x1, y1, 1, -1), left1 = corner(x1, y1, 1, 1);
  corners_.insert(corners_.end(), {right0, right1, left1, right0, left1, left0});
}

void Lettering::write(std::string_view text, double x, double y) {
  for (const Stroke& stroke : strokes_of(text)) {
    line(x + height_ * stroke.x0, y + height_ * stroke.y0, x + height_ * stroke.x1, y + height_ * stroke.y1);
  }
}

double Lettering::width(std::string_view text) const noexcept { return height_ * text_width(text); }

int add_ink(GlbScene& scene) {
  // Light 0.18 has the same contrast, 4.6, to white and to black (WCAG 2.1, contrast ratio).
  return scene.add_material(
      {{"name", "ink"},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {0.18, 0.18, 0.18, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}},
       {"doubleSided", true},
       {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
}

}  // namespace cdfr
