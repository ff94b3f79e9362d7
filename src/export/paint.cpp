#include "export/paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "export/number_text.h"
#include "export/text_line.h"

namespace cdfr {
namespace {

constexpr std::size_t longest_name = 63;
constexpr std::array<std::string_view, 12> taken_names{
    "x", "y", "z", "red", "green", "blue", "alpha", "patch", "colour", "radius", "label", "vertex_indices"};

bool is_name(std::string_view name) {
  const auto letter = [](char c) { return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return !name.empty() && name.size() <= longest_name && letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); }) &&
         std::find(taken_names.begin(), taken_names.end(), name) == taken_names.end();
}

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Result<void> check_array(const PaintedMesh& painted, std::size_t i) {
  const MeshArray& array = painted.arrays[i];
  const std::string shown = "'" + text_line(array.name) + "'";
  if (!is_name(array.name)) return Error{Code::bad_option, i, shown + " cannot be the name of an array"};
  for (std::size_t k = 0; k < i; ++k) {
    if (painted.arrays[k].name == array.name)
      return Error{Code::bad_option, i, "two arrays have the name " + shown};
  }
  const bool of_vertices = array.place == ArrayPlace::vertex;
  const std::size_t count = of_vertices ? painted.mesh.vertices.size() : painted.mesh.triangles.size();
  if (array.values.size() == count) return {};
  return Error{Code::bad_option, i,
               "array " + shown + " has " + std::to_string(array.values.size()) + " values for " +
                   std::to_string(count) + (of_vertices ? " vertices" : " triangles")};
}

}  // namespace

Paint::Paint(const PaintedMesh& painted) noexcept : least_(painted.least), greatest_(painted.greatest) {
  if (painted.painted.empty()) return;
  for (const MeshArray& array : painted.arrays) {
    if (array.name == painted.painted) array_ = &array;
  }
}

Result<void> check_painted(const PaintedMesh& painted) {
  for (std::size_t i = 0; i < painted.arrays.size(); ++i) {
    if (auto checked = check_array(painted, i); !checked) return checked;
  }
  if (!painted.painted.empty() && !Paint(painted).any()) {
    return Error{Code::bad_option, 0, "there is no array '" + text_line(painted.painted) + "' to paint"};
  }
  if (!std::isfinite(painted.least) || !std::isfinite(painted.greatest) || painted.least > painted.greatest) {
    return Error{Code::bad_option, 0, "the painted range must be finite, its ends in order"};
  }
  for (std::size_t i = 0; i < painted.balls.size(); ++i) {
    const auto& [centre, radius] = painted.balls[i];
    const double reach = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)}) + radius;
    if (finite(centre) && std::isfinite(reach) && radius > 0) continue;
    return Error{Code::bad_option, i, "ball " + std::to_string(i) + " is not finite, or has no radius"};
  }
  for (std::size_t i = 0; i < painted.labels.size(); ++i) {
    if (finite(painted.labels[i].place)) continue;
    return Error{Code::bad_option, i, "the place of label " + std::to_string(i) + " is not finite"};
  }
  return {};
}

std::string range_text(const PaintedMesh& painted) {
  std::string text = painted.painted + " from ";
  append_number(text, painted.least);
  text += " (yellow) to ";
  append_number(text, painted.greatest);
  text += " (dark blue)";
  return painted.unit.empty() ? text : text + " " + text_line(painted.unit);
}

}  // namespace cdfr
