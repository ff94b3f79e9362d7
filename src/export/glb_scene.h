/// A GLB file as it is put together: its JSON, and the bytes of all that is small.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/whole_file.h"
#include "export/glb_format.h"

namespace cdfr {

using Json = nlohmann::ordered_json;

/// Every add_... gives the number by which the file's other parts name what was added.
class GlbScene {
 public:
  /// Three floats a vertex. Precondition of both: not empty.
  int add_positions(std::span<const glb::Float3> positions);  ///< with the bounds that the format asks for
  int add_colours(std::span<const glb::Float3> colours);      ///< linear, 0 to 1
  int add_indices(std::span<const std::uint32_t> indices);

  /// A view of bytes that do not lie in memory: they follow all others, in the order of these calls.
  int add_later_view(std::uint64_t bytes, std::uint32_t stride, int target);
  int add_accessor(Json accessor) { return add("accessors", std::move(accessor)); }
  int add_material(Json material) { return add("materials", std::move(material)); }
  int add_mesh(const Json& primitives);
  /// It hangs under the root.
  void add_node(Json node);

  /// Sizes, header, JSON and the bytes in memory; what was to come later is the caller's to append. Error:
  /// file_write beyond 4 GiB.
  Result<void> write(Json asset, Json root_node, WholeFile& file);

 private:
  int add(const char* list, Json item);
  int add_view(std::span<const std::byte> bytes, int target);
  int add_vectors(std::span<const glb::Float3> vectors, Json accessor);
  void place_later_views();

  Json lists_ = Json::object();  ///< accessors, bufferViews, ...
  std::vector<std::byte> bytes_;
  std::vector<int> later_views_;
  std::uint64_t later_bytes_ = 0;
  std::vector<int> nodes_;
};

/// Refuses a GLB of so many bytes if the format's 32 bits cannot count them.
Result<void> check_glb_bytes(std::uint64_t bytes);

}  // namespace cdfr
