/// Layout: header, a JSON chunk of fixed size, one binary chunk of interleaved float32 positions and normals.
/// The JSON needs the count and the box of the points, so its place is kept free and filled at the end.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "cdfr/version.h"
#include "export/glb_format.h"
#include "export/little_endian.h"
#include "export/point_formats.h"

namespace cdfr {
namespace {

using Json = nlohmann::ordered_json;

using namespace glb;

constexpr std::uint32_t json_bytes = 2048;
constexpr std::uint32_t points_start = json_start + json_bytes + chunk_header_bytes;
constexpr std::uint32_t point_bytes = 24;

class GlbPoints final : public PointFormat {
 public:
  explicit GlbPoints(double metres_per_unit) : metres_per_unit_(metres_per_unit) {}

  std::uint64_t limit() const noexcept override {
    return (std::numeric_limits<std::uint32_t>::max() - points_start) / point_bytes;
  }
  Result<void> begin(WholeFile& file) override {
    return file.write(std::string(json_start + json_bytes, ' '));
  }
  Result<void> append(WholeFile& file, std::span<const ContourPoint> points) override;
  Result<void> end(WholeFile& file, std::uint64_t count) override;

 private:
  Result<void> append(WholeFile& file, const ContourPoint& point);
  Json scene(std::uint64_t count) const;

  double metres_per_unit_;
  bool started_ = false;
  /// The first point: a function of the points alone, not of how they are cut into blocks.
  Vec3 origin_;
  Float3 lo_{}, hi_{};
};

Result<void> GlbPoints::append(WholeFile& file, std::span<const ContourPoint> points) {
  if (!started_ && !points.empty()) {
    started_ = true;
    origin_ = points.front().position;
    const double m = metres_per_unit_;
    for (const double coordinate : {origin_.x, origin_.y, origin_.z}) {
      if (!std::isfinite(coordinate * m))
        return Error{Code::file_write, 0, "the points are too far away in metres"};
    }
    if (auto written = file.write(std::string(chunk_header_bytes, '\0')); !written) return written;
  }
  for (const ContourPoint& point : points) {
    if (auto written = append(file, point); !written) return written;
  }
  return {};
}

Result<void> GlbPoints::append(WholeFile& file, const ContourPoint& point) {
  const Vec3 p = point.position, n = point.normal;
  const std::array<double, 6> values = {p.x - origin_.x, p.y - origin_.y, p.z - origin_.z, n.x, n.y, n.z};
  Record<point_bytes> record;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!(std::abs(values[k]) <= std::numeric_limits<float>::max())) {
      return Error{Code::file_write, 0, "the points are too far apart for the float32 of a GLB file"};
    }
    const auto number = static_cast<float>(values[k]);
    record.append(number);
    if (k >= 3) continue;
    lo_[k] = std::min(lo_[k], number);
    hi_[k] = std::max(hi_[k], number);
  }
  return file.write(record.bytes());
}

/// A scene without a node if there are no points: an accessor of none is not allowed.
Json GlbPoints::scene(std::uint64_t count) const {
  Json root;
  root["asset"] = {{"version", "2.0"}, {"generator", std::string("cdfr ") + version()}};
  root["scene"] = 0;
  if (count == 0) {
    root["scenes"] = Json::array({Json::object()});
    return root;
  }
  const double m = metres_per_unit_;
  root["scenes"] = Json::array({{{"nodes", {0}}}});
  root["nodes"] = Json::array(
      {{{"mesh", 0}, {"translation", {origin_.x * m, origin_.y * m, origin_.z * m}}, {"scale", {m, m, m}}}});
  root["meshes"] =
      Json::array({{{"primitives", Json::array({{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}},
                                                 {"material", 0},
                                                 {"mode", points_mode}}})}}});
  root["materials"] = Json::array(
      {{{"pbrMetallicRoughness",
         {{"baseColorFactor", {0.85, 0.2, 0.06, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}}}});
  const Json of_all = {
      {"bufferView", 0}, {"componentType", float_component}, {"count", count}, {"type", "VEC3"}};
  Json positions = of_all, normals = of_all;
  positions["byteOffset"] = 0;
  positions["min"] = lo_;
  positions["max"] = hi_;
  normals["byteOffset"] = point_bytes / 2;
  root["accessors"] = {positions, normals};
  root["bufferViews"] = Json::array({{{"buffer", 0},
                                      {"byteLength", count * point_bytes},
                                      {"byteStride", point_bytes},
                                      {"target", vertex_target}}});
  root["buffers"] = Json::array({{{"byteLength", count * point_bytes}}});
  return root;
}

Result<void> GlbPoints::end(WholeFile& file, std::uint64_t count) {
  std::string text = scene(count).dump();
  // Numbers have a greatest length, so the text has one: about 1400 bytes.
  assert(text.size() <= json_bytes);
  text.resize(json_bytes, ' ');
  Record<json_start> header;
  header.append(magic);
  header.append(version_2);
  header.append(static_cast<std::uint32_t>(file.size()));
  header.append(json_bytes);
  header.append(json_chunk);
  if (auto written = file.write_at(0, header.bytes()); !written) return written;
  if (auto written = file.write_at(json_start, text); !written || count == 0) return written;
  Record<chunk_header_bytes> chunk;
  chunk.append(static_cast<std::uint32_t>(count * point_bytes));
  chunk.append(binary_chunk);
  return file.write_at(json_start + json_bytes, chunk.bytes());
}

}  // namespace

std::unique_ptr<PointFormat> glb_points(double metres_per_unit) {
  return std::make_unique<GlbPoints>(metres_per_unit);
}

}  // namespace cdfr
