#include "export/glb_scene.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "export/little_endian.h"

namespace cdfr {

using namespace glb;

int GlbScene::add(const char* list, Json item) {
  Json& items = lists_[list];
  items.push_back(std::move(item));
  return static_cast<int>(items.size()) - 1;
}

int GlbScene::add_view(std::span<const std::byte> bytes, int target) {
  const Json view = {
      {"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}, {"target", target}};
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return add("bufferViews", view);
}

int GlbScene::add_vectors(std::span<const Float3> vectors, Json accessor) {
  assert(!vectors.empty());
  std::vector<std::byte> bytes;
  bytes.reserve(vectors.size() * sizeof(Float3));
  for (const Float3& vector : vectors) {
    Record<sizeof(Float3)> record;
    for (const float number : vector) record.append(number);
    bytes.insert(bytes.end(), record.bytes().begin(), record.bytes().end());
  }
  accessor["bufferView"] = add_view(bytes, vertex_target);
  accessor["componentType"] = float_component;
  accessor["count"] = vectors.size();
  accessor["type"] = "VEC3";
  return add_accessor(std::move(accessor));
}

int GlbScene::add_positions(std::span<const Float3> positions) {
  Float3 lo = positions.front(), hi = lo;
  for (const Float3& position : positions) {
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], position[k]);
      hi[k] = std::max(hi[k], position[k]);
    }
  }
  return add_vectors(positions, {{"min", lo}, {"max", hi}});
}

int GlbScene::add_colours(std::span<const Float3> colours) { return add_vectors(colours, Json::object()); }

int GlbScene::add_indices(std::span<const std::uint32_t> indices) {
  assert(!indices.empty());
  std::vector<std::byte> bytes;
  for (const std::uint32_t index : indices) {
    Record<4> record;
    record.append(index);
    bytes.insert(bytes.end(), record.bytes().begin(), record.bytes().end());
  }
  return add_accessor({{"bufferView", add_view(bytes, index_target)},
                       {"componentType", unsigned_component},
                       {"count", indices.size()},
                       {"type", "SCALAR"}});
}

int GlbScene::add_later_view(std::uint64_t bytes, std::uint32_t stride, int target) {
  assert(bytes % 4 == 0);
  Json view = {{"buffer", 0}, {"byteOffset", later_bytes_}, {"byteLength", bytes}, {"target", target}};
  if (stride > 0) view["byteStride"] = stride;
  later_bytes_ += bytes;
  later_views_.push_back(add("bufferViews", std::move(view)));
  return later_views_.back();
}

int GlbScene::add_mesh(const Json& primitives) { return add("meshes", {{"primitives", primitives}}); }

void GlbScene::add_node(Json node) { nodes_.push_back(add("nodes", std::move(node))); }

void GlbScene::place_later_views() {
  for (const int view : std::exchange(later_views_, {})) {
    Json& offset = lists_["bufferViews"][static_cast<std::size_t>(view)]["byteOffset"];
    offset = offset.get<std::uint64_t>() + bytes_.size();
  }
}

Result<void> GlbScene::write(Json asset, Json root_node, WholeFile& file) {
  place_later_views();
  Json root;
  root["asset"] = std::move(asset);
  root["extensionsUsed"] = Json::array({"KHR_materials_unlit"});
  root["scene"] = 0;
  root["scenes"] = Json::array({Json::object()});
  if (!nodes_.empty()) {
    root_node["children"] = nodes_;
    root["scenes"][0]["nodes"] = Json::array({add("nodes", std::move(root_node))});
  }
  root.update(lists_);
  const std::uint64_t binary = bytes_.size() + later_bytes_;
  if (binary > 0) root["buffers"] = Json::array({{{"byteLength", binary}}});
  std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t bytes = json_start + text.size() + (binary > 0 ? chunk_header_bytes + binary : 0);
  if (auto checked = check_glb_bytes(bytes); !checked) return checked;

  Record<json_start> header;
  header.append(magic);
  header.append(version_2);
  header.append(static_cast<std::uint32_t>(bytes));
  header.append(static_cast<std::uint32_t>(text.size()));
  header.append(json_chunk);
  if (auto written = file.write(header.bytes()); !written) return written;
  if (auto written = file.write(text); !written || binary == 0) return written;
  Record<chunk_header_bytes> chunk;
  chunk.append(static_cast<std::uint32_t>(binary));
  chunk.append(binary_chunk);
  if (auto written = file.write(chunk.bytes()); !written) return written;
  return file.write(bytes_);
}

Result<void> check_glb_bytes(std::uint64_t bytes) {
  if (bytes <= std::numeric_limits<std::uint32_t>::max()) return {};
  return Error{Code::file_write, bytes,
               "a GLB holds at most 4 GiB, and this one would take " + std::to_string(bytes) +
                   " bytes; PLY and VTP have no limit"};
}

}  // namespace cdfr
