/// A glTF or GLB file taken apart: its JSON, and the bytes of its buffers. Nothing outside the file is ever
/// opened. The functions of the gltf_* files throw Failure at a fault; read_gltf turns it into a Result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cdfr/core/result.h"

namespace cdfr {

using Json = nlohmann::json;

struct GltfDocument {
  Json root;
  std::vector<std::span<const std::byte>> buffers;  ///< into the file or into `decoded`
  std::list<std::vector<std::byte>> decoded;        ///< data: URIs
};

/// `bytes` must outlive the document.
GltfDocument open_gltf(std::span<const std::byte> bytes);

/// An object of one of the arrays at the top of the JSON, for messages: "accessor 3".
struct GltfPlace {
  std::string_view kind;
  std::uint64_t index = 0;
};

[[noreturn]] void refuse(Code code, const GltfPlace& place, std::string_view text);

/// root[array][place.index], an object; refused if it is not there.
const Json& gltf_object(const Json& root, const char* array, const GltfPlace& place);
/// object[key], an array; an empty one if it is not there.
const Json& array_member(const Json& object, const char* key, const GltfPlace& place);
/// object[key], a whole number from 0 up; `fallback` if it is not there, refused if that is not given either.
std::uint64_t unsigned_member(const Json& object, const char* key, const GltfPlace& place,
                              std::optional<std::uint64_t> fallback = std::nullopt);
/// The numbers of object[key], exactly `values.size()`; false if it is not there.
bool numbers_member(const Json& object, const char* key, const GltfPlace& place, std::span<double> values);

}  // namespace cdfr
