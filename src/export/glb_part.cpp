#include "export/glb_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "export/linear_light.h"
#include "export/little_endian.h"

namespace cdfr {
namespace {

using namespace glb;

constexpr std::uint32_t colour_offset = 12, value_offset = 24;

/// The format forbids what is not finite: NaN becomes the lowest float, the rest is brought into the range.
float finite_float(double value) noexcept {
  constexpr double most = std::numeric_limits<float>::max();
  return std::isnan(value) ? std::numeric_limits<float>::lowest()
                           : static_cast<float>(std::clamp(value, -most, most));
}

}  // namespace

std::uint64_t GlbPart::vertices() const noexcept {
  if (empty()) return 0;
  return by_triangle() ? 3 * std::uint64_t{painted_.mesh.triangles.size()} : painted_.mesh.vertices.size();
}

std::uint64_t GlbPart::index_bytes() const noexcept {
  return by_triangle() ? 0 : 12 * std::uint64_t{painted_.mesh.triangles.size()};
}

Vec3 GlbPart::position(std::uint64_t i) const noexcept {
  const MeshView& mesh = painted_.mesh;
  return mesh.vertices[by_triangle() ? mesh.triangles[i / 3][i % 3] : i];
}

Json GlbPart::positions(int view) const {
  constexpr float most = std::numeric_limits<float>::max();
  Float3 lo{most, most, most}, hi{-most, -most, -most};
  for (std::uint64_t i = 0; i < vertices(); ++i) {
    const Float3 p = frame_.rounded(position(i));
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], p[k]);
      hi[k] = std::max(hi[k], p[k]);
    }
  }
  return {{"bufferView", view},  {"componentType", float_component},
          {"count", vertices()}, {"type", "VEC3"},
          {"min", lo},           {"max", hi}};
}

void GlbPart::declare(int material, GlbScene& scene) const {
  if (empty()) return;
  const int view = scene.add_later_view(vertices() * stride(), stride(), vertex_target);
  const Json of_all = {
      {"bufferView", view}, {"componentType", float_component}, {"count", vertices()}, {"type", "VEC3"}};
  Json attributes = {{"POSITION", scene.add_accessor(positions(view))}};
  if (paint_.any()) {
    Json colours = of_all, values = of_all;
    colours["byteOffset"] = colour_offset;
    values["byteOffset"] = value_offset;
    values["type"] = "SCALAR";
    attributes["COLOR_0"] = scene.add_accessor(colours);
    attributes["_VALUE"] = scene.add_accessor(values);
  }
  Json primitive = {{"attributes", attributes}, {"material", material}, {"mode", triangles_mode}};
  if (!by_triangle()) {
    primitive["indices"] =
        scene.add_accessor({{"bufferView", scene.add_later_view(index_bytes(), 0, index_target)},
                            {"componentType", unsigned_component},
                            {"count", index_bytes() / 4},
                            {"type", "SCALAR"}});
  }
  scene.add_node({{"name", "part"}, {"mesh", scene.add_mesh(Json::array({primitive}))}});
}

Result<void> GlbPart::write_vertex(std::uint64_t i, std::span<const float, 256> linear,
                                   WholeFile& file) const {
  Record<28> record;
  for (const float coordinate : frame_.rounded(position(i))) record.append(coordinate);
  if (paint_.any()) {
    const std::uint64_t place = by_triangle() ? i / 3 : i;
    for (const std::uint8_t channel : paint_.colour(place)) record.append(linear[channel]);
    record.append(finite_float(paint_.value(place)));
  }
  return file.write(record.bytes());
}

Result<void> GlbPart::write(WholeFile& file) const {
  const auto linear = linear_light();
  for (std::uint64_t i = 0; i < vertices(); ++i) {
    if (auto written = write_vertex(i, linear, file); !written) return written;
  }
  if (by_triangle()) return {};
  for (const Triangle& triangle : painted_.mesh.triangles) {
    Record<12> record;
    for (const std::uint32_t corner : triangle) record.append(corner);
    if (auto written = file.write(record.bytes()); !written) return written;
  }
  return {};
}

}  // namespace cdfr
