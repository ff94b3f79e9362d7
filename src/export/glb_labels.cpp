#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "export/glb_beside.h"
#include "export/lettering.h"
#include "export/text_line.h"

namespace cdfr {
namespace {

using namespace glb;

/// From one base line to the next, in heights of capitals.
constexpr double pitch = 2;

/// Highest place first, so that their lines hardly cross; of two as high the earlier one.
std::vector<std::size_t> order_of(const std::vector<PaintedLabel>& labels) {
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return labels[a].place.y > labels[b].place.y; });
  return order;
}

void add_label(const PaintedLabel& label, const Frame& frame, double y, int ink, GlbScene& scene) {
  const double height = letter_share * frame.diagonal();
  const double right = frame.box().lo.x - 2 * height;
  const std::string text = text_line(label.text);
  Lettering letters(height, 0);
  letters.write(text, right - letters.width(text), y);
  const std::array<Float3, 2> line{
      Float3{static_cast<float>(right + height / 2), static_cast<float>(y + height / 2), 0},
      frame.rounded(label.place)};
  Json primitives = Json::array(
      {{{"attributes", {{"POSITION", scene.add_positions(line)}}}, {"material", ink}, {"mode", lines_mode}}});
  if (!letters.corners().empty()) {
    primitives.push_back({{"attributes", {{"POSITION", scene.add_positions(letters.corners())}}},
                          {"material", ink},
                          {"mode", triangles_mode}});
  }
  const Vec3 place = label.place;
  scene.add_node({{"name", text},
                  {"mesh", scene.add_mesh(primitives)},
                  {"extras", {{"place", {place.x, place.y, place.z}}}}});
}

}  // namespace

void add_labels(const PaintedMesh& painted, const Frame& frame, int ink, GlbScene& scene) {
  const double step = pitch * letter_share * frame.diagonal();
  double y = step * (static_cast<double>(painted.labels.size()) / 2 - 1);
  for (const std::size_t i : order_of(painted.labels)) {
    add_label(painted.labels[i], frame, y, ink, scene);
    y -= step;
  }
}

}  // namespace cdfr
