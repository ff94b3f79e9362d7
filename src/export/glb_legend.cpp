#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "export/glb_beside.h"
#include "export/lettering.h"
#include "export/linear_light.h"
#include "export/paint.h"
#include "export/text_line.h"

namespace cdfr {
namespace {

using namespace glb;

constexpr int bar_quads = 60, ticks = 5, tick_digits = 5;

std::string tick_text(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, tick_digits);
  return {text.data(), end.ptr};
}

/// Upright, `height` high, its lower left corner at (x, y), all in the frame.
class Bar {
 public:
  Bar(const PaintedMesh& painted, double x, double y, double width, double height)
      : painted_(painted), x_(x), y_(y), width_(width), height_(height) {
    for (int i = 0; i < bar_quads; ++i) {
      const double from = share(i, bar_quads), to = share(i + 1, bar_quads);
      quad(level(from), level(to), colour_at(value_at(from)), colour_at(value_at(to)));
    }
  }

  /// Each end has exactly the range's value.
  double value_at(double share) const noexcept {
    return (1 - share) * painted_.least + share * painted_.greatest;
  }
  double level(double share) const noexcept { return y_ + share * height_; }
  static double share(int i, int of) noexcept { return static_cast<double>(i) / of; }

  /// A square under the bar, for places without a value; its top is `gap` below.
  void add_gap_square(double gap) {
    const Float3 colour = colour_at(std::numeric_limits<double>::quiet_NaN());
    quad(y_ - gap - width_, y_ - gap, colour, colour);
  }

  Json primitive(int material, GlbScene& scene) const {
    return {{"attributes",
             {{"POSITION", scene.add_positions(positions_)}, {"COLOR_0", scene.add_colours(colours_)}}},
            {"material", material},
            {"mode", triangles_mode}};
  }

 private:
  Float3 colour_at(double value) const noexcept {
    const Colour colour = painted_colour(value, painted_.least, painted_.greatest);
    return {linear_[colour[0]], linear_[colour[1]], linear_[colour[2]]};
  }
  void quad(double bottom, double top, const Float3& below, const Float3& above) {
    const auto at = [&](double x, double y) {
      return Float3{static_cast<float>(x), static_cast<float>(y), 0};
    };
    const double right = x_ + width_;
    positions_.insert(positions_.end(), {at(x_, bottom), at(right, bottom), at(right, top), at(x_, bottom),
                                         at(right, top), at(x_, top)});
    colours_.insert(colours_.end(), {below, below, above, below, above, above});
  }

  const PaintedMesh& painted_;
  double x_, y_, width_, height_;
  std::array<float, 256> linear_ = linear_light();
  std::vector<Float3> positions_, colours_;
};

bool has_gaps(const PaintedMesh& painted) {
  for (const MeshArray& array : painted.arrays) {
    if (array.name == painted.painted)
      return std::any_of(array.values.begin(), array.values.end(), [](double v) { return std::isnan(v); });
  }
  return false;
}

int add_bar_material(GlbScene& scene) {
  return scene.add_material(
      {{"name", "legend"}, {"doubleSided", true}, {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
}

}  // namespace

void add_legend(const PaintedMesh& painted, const Frame& frame, int ink, GlbScene& scene) {
  if (!Paint(painted).any()) return;
  const double letter = letter_share * frame.diagonal(), width = 1.5 * letter;
  const double height = frame.diagonal() / 2;
  const double left = frame.box().hi.x + 2 * letter, right = left + width;
  Bar bar(painted, left, -height / 2, width, height);
  Lettering letters(letter, 0);
  for (int i = 0; i < ticks; ++i) {
    const double share = Bar::share(i, ticks - 1), y = bar.level(share);
    letters.line(right, y, right + letter / 2, y);
    letters.write(tick_text(bar.value_at(share)), right + letter, y - letter / 2);
  }
  const std::string unit = painted.unit.empty() ? "" : ", " + text_line(painted.unit);
  letters.write(painted.painted + unit, left, bar.level(1) + 1.5 * letter);
  if (has_gaps(painted)) {
    bar.add_gap_square(letter);
    letters.write("no value", right + letter, bar.level(0) - letter - width / 2 - letter / 2);
  }
  const Json text = {{"attributes", {{"POSITION", scene.add_positions(letters.corners())}}},
                     {"material", ink},
                     {"mode", triangles_mode}};
  const Json primitives = Json::array({bar.primitive(add_bar_material(scene), scene), text});
  scene.add_node({{"name", "legend"}, {"mesh", scene.add_mesh(primitives)}});
}

}  // namespace cdfr
