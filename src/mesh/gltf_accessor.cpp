#include "mesh/gltf_accessor.h"

#include <algorithm>
#include <string>

#include "core/bytes.h"

namespace cdfr {
namespace {

enum ComponentType : std::uint64_t {
  type_int8 = 5120,
  type_uint8 = 5121,
  type_int16 = 5122,
  type_uint16 = 5123,
  type_uint32 = 5125,
  type_float = 5126
};

std::uint64_t component_size(std::uint64_t type, const GltfPlace& place) {
  switch (type) {
    case type_int8:
    case type_uint8:
      return 1;
    case type_int16:
    case type_uint16:
      return 2;
    case type_uint32:
    case type_float:
      return 4;
    default:
      refuse(Code::file_format, place, "componentType " + std::to_string(type) + " is not known");
  }
}

struct View {
  std::span<const std::byte> bytes;
  std::uint64_t stride = 0;  ///< 0: tightly packed
};

View view_of(const GltfDocument& document, std::uint64_t index) {
  const GltfPlace place{"bufferView", index};
  const Json& view = gltf_object(document.root, "bufferViews", place);
  const std::uint64_t buffer = unsigned_member(view, "buffer", place);
  if (buffer >= document.buffers.size()) refuse(Code::bad_index, place, "buffer is not there");
  const auto bytes = document.buffers[buffer];
  const std::uint64_t offset = unsigned_member(view, "byteOffset", place, 0);
  const std::uint64_t length = unsigned_member(view, "byteLength", place);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    refuse(Code::file_truncated, place,
           "offset " + std::to_string(offset) + " and length " + std::to_string(length) +
               ", its buffer has " + std::to_string(bytes.size()) + " bytes");
  }
  const std::uint64_t stride = unsigned_member(view, "byteStride", place, 0);
  if (view.contains("byteStride") && (stride < 4 || stride > 252)) {
    refuse(Code::file_format, place, "byteStride is not 4 to 252");
  }
  return {bytes.subspan(offset, length), stride};
}

bool flag_member(const Json& object, const char* key, const GltfPlace& place) {
  const auto member = object.find(key);
  if (member == object.end()) return false;
  if (!member->is_boolean())
    refuse(Code::file_format, place, std::string(key) + " is neither true nor false");
  return member->get<bool>();
}

}  // namespace

GltfAccessor::GltfAccessor(const GltfDocument& document, std::uint64_t index, std::string_view type,
                           std::uint64_t components) {
  const GltfPlace place{"accessor", index};
  const Json& accessor = gltf_object(document.root, "accessors", place);
  if (accessor.contains("sparse")) refuse(Code::file_format, place, "sparse accessors are not supported");
  const auto found = accessor.find("type");
  if (found == accessor.end() || *found != type)
    refuse(Code::file_format, place, "type is not " + std::string(type));
  component_type_ = unsigned_member(accessor, "componentType", place);
  const std::uint64_t size = components * component_size(component_type_, place);
  normalized_ = flag_member(accessor, "normalized", place);
  count_ = unsigned_member(accessor, "count", place);
  const View view = view_of(document, unsigned_member(accessor, "bufferView", place));
  stride_ = view.stride == 0 ? size : view.stride;
  if (stride_ < size)
    refuse(Code::file_format, place, "elements overlap: byteStride is less than their size");
  const std::uint64_t offset = unsigned_member(accessor, "byteOffset", place, 0);
  if (count_ == 0) return;
  const std::uint64_t length = view.bytes.size();
  if (offset > length || size > length - offset || count_ - 1 > (length - offset - size) / stride_) {
    refuse(Code::file_truncated, place,
           std::to_string(count_) + " elements from byte " + std::to_string(offset) + " do not fit the " +
               std::to_string(length) + " bytes of their bufferView");
  }
  data_ = view.bytes.data() + offset;
}

GltfAccessor GltfAccessor::positions(const GltfDocument& document, std::uint64_t index) {
  GltfAccessor accessor(document, index, "VEC3", 3);
  if (accessor.component_type_ == type_uint32) {
    refuse(Code::file_format, {"accessor", index}, "positions of 32 bit integers are not in the standard");
  }
  return accessor;
}

GltfAccessor GltfAccessor::indices(const GltfDocument& document, std::uint64_t index) {
  GltfAccessor accessor(document, index, "SCALAR", 1);
  const std::uint64_t type = accessor.component_type_;
  if ((type != type_uint8 && type != type_uint16 && type != type_uint32) || accessor.normalized_) {
    refuse(Code::file_format, {"accessor", index}, "indices are no unsigned integers");
  }
  return accessor;
}

double GltfAccessor::component(const std::byte* at) const noexcept {
  double value = 0, scale = 1;
  switch (component_type_) {
    case type_int8:
      value = load_little<std::int8_t>(at);
      scale = 127;
      break;
    case type_uint8:
      value = load_little<std::uint8_t>(at);
      scale = 255;
      break;
    case type_int16:
      value = load_little<std::int16_t>(at);
      scale = 32767;
      break;
    case type_uint16:
      value = load_little<std::uint16_t>(at);
      scale = 65535;
      break;
    default:
      return load_little<float>(at);
  }
  return normalized_ ? std::max(value / scale, -1.0) : value;
}

Vec3 GltfAccessor::position(std::uint64_t i) const noexcept {
  const std::byte* at = data_ + i * stride_;
  const std::size_t size = component_type_ == type_float                                     ? 4
                           : component_type_ == type_int16 || component_type_ == type_uint16 ? 2
                                                                                             : 1;
  return {component(at), component(at + size), component(at + 2 * size)};
}

std::uint32_t GltfAccessor::index(std::uint64_t i) const noexcept {
  const std::byte* at = data_ + i * stride_;
  if (component_type_ == type_uint8) return load_little<std::uint8_t>(at);
  if (component_type_ == type_uint16) return load_little<std::uint16_t>(at);
  return load_little<std::uint32_t>(at);
}

}  // namespace cdfr
