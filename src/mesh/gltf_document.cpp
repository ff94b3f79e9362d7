#include "mesh/gltf_document.h"

#include <cmath>
#include <utility>

#include "core/bytes.h"
#include "mesh/text.h"

namespace cdfr {
namespace {

constexpr std::uint32_t chunk_json = 0x4e4f534a;
constexpr std::uint32_t chunk_binary = 0x004e4942;
// A parsed value takes many times the bytes of its text; these hold memory to what a real file needs.
constexpr int deepest_json = 64;
constexpr std::uint64_t most_json_values = std::uint64_t{1} << 24;

struct Chunks {
  std::span<const std::byte> json;
  std::span<const std::byte> binary;
  bool has_binary = false;
  std::uint64_t json_offset = 0;
};

[[noreturn]] void refuse_byte(Code code, std::uint64_t byte, std::string_view text) {
  throw Failure({code, byte, "byte " + std::to_string(byte) + ": " + std::string(text)});
}

void check_glb_header(ByteReader& reader, std::uint64_t size) {
  reader.take(4);  // the magic, by which the file was known
  const auto version = reader.little<std::uint32_t>();
  const auto length = reader.little<std::uint32_t>();
  if (!length) refuse_byte(Code::file_truncated, size, "GLB ends inside its header");
  if (*version != 2)
    refuse_byte(Code::file_version, 4, "GLB version " + std::to_string(*version) + " is not 2");
  if (*length == size) return;
  refuse_byte(*length > size ? Code::file_truncated : Code::file_format, 8,
              "GLB says it has " + std::to_string(*length) + " bytes, the file has " + std::to_string(size));
}

Chunks split_glb(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  check_glb_header(reader, bytes.size());
  Chunks chunks;
  for (int number = 0; reader.remaining() > 0; ++number) {
    const std::uint64_t start = reader.offset();
    const auto length = reader.little<std::uint32_t>();
    const auto type = reader.little<std::uint32_t>();
    if (!type) refuse_byte(Code::file_truncated, start, "GLB chunk is cut off");
    const auto data = reader.take(*length);
    if (!data) {
      refuse_byte(Code::file_truncated, start,
                  "GLB chunk of " + std::to_string(*length) + " bytes, the file has " +
                      std::to_string(reader.remaining()) + " left");
    }
    if ((number == 0) != (*type == chunk_json))
      refuse_byte(Code::file_format, start, "GLB needs one JSON chunk, first");
    if (*type == chunk_json) {
      chunks.json = *data;
      chunks.json_offset = start + 8;
    } else if (*type == chunk_binary && number == 1) {
      chunks.binary = *data;
      chunks.has_binary = true;
    }
  }
  if (chunks.json.empty()) refuse_byte(Code::file_truncated, bytes.size(), "GLB has no JSON");
  return chunks;
}

/// Bounds depth and number of values before the parser builds any.
void check_json_shape(std::string_view text, std::uint64_t offset) {
  std::uint64_t values = 0;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (c == ',' || c == '{' || c == '[') ++values;
    if (depth > deepest_json) refuse_byte(Code::file_format, offset + i, "JSON is nested deeper than 64");
    if (values > most_json_values)
      refuse_byte(Code::file_format, offset + i, "JSON has more than 2^24 values");
  }
}

Json parse_json(std::span<const std::byte> bytes, std::uint64_t offset) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  check_json_shape(text, offset);
  try {
    Json root = Json::parse(text);
    if (!root.is_object()) refuse_byte(Code::file_format, offset, "JSON is no object");
    return root;
  } catch (const Json::parse_error& error) {
    const bool at_end = error.byte > text.size();
    refuse_byte(at_end ? Code::file_truncated : Code::file_format, offset + error.byte - (error.byte > 0),
                at_end ? "JSON is cut off" : "JSON is malformed");
  } catch (const Json::exception&) {
    refuse_byte(Code::file_format, offset, "JSON has a number that no double can hold");
  }
}

void check_asset(const Json& root) {
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object()) throw Failure({Code::file_format, 0, "glTF has no asset"});
  for (const char* key : {"version", "minVersion"}) {
    const auto version = asset->find(key);
    if (version == asset->end() && key == std::string_view("minVersion")) continue;
    if (version == asset->end() || !version->is_string())
      throw Failure({Code::file_format, 0, "glTF has no version"});
    const auto& text = version->get_ref<const std::string&>();
    if (!text.starts_with("2."))
      throw Failure({Code::file_version, 0, "glTF version " + in_quotes(text) + " is not 2"});
  }
}

int base64_digit(char c) noexcept {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

std::vector<std::byte> decode_base64(std::string_view text, const GltfPlace& place) {
  if (text.size() % 4 == 0) {
    for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  }
  if (text.size() % 4 == 1) refuse(Code::file_truncated, place, "base64 is cut off");
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int digit = base64_digit(text[i]);
    if (digit < 0) refuse(Code::file_format, place, "base64 has a wrong character at " + std::to_string(i));
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    // Every digit but the first of four completes a byte: 6 + 6, 4 + 6, 2 + 6 bits.
    if (const auto phase = i % 4; phase != 0)
      bytes.push_back(static_cast<std::byte>(bits >> (6 - 2 * phase) & 0xff));
  }
  return bytes;
}

/// The URI of a buffer or image, which must be inside the file: "data:". Null if there is none.
const std::string* inner_uri(const Json& object, const GltfPlace& place) {
  const auto uri = object.find("uri");
  if (uri == object.end()) return nullptr;
  if (!uri->is_string()) refuse(Code::file_format, place, "uri is no string");
  const auto& text = uri->get_ref<const std::string&>();
  if (!text.starts_with("data:"))
    refuse(Code::file_format, place, "external file " + in_quotes(text) + " is not opened");
  return &text;
}

std::span<const std::byte> data_of(const std::string& uri, const GltfPlace& place, GltfDocument& document) {
  const auto comma = uri.find(',');
  const std::string_view head = std::string_view(uri).substr(0, comma);
  if (comma == uri.npos || !head.ends_with(";base64"))
    refuse(Code::file_format, place, "data URI is not base64");
  document.decoded.push_back(decode_base64(std::string_view(uri).substr(comma + 1), place));
  return document.decoded.back();
}

void open_buffers(GltfDocument& document, const Chunks& chunks) {
  const std::size_t count = array_member(document.root, "buffers", {"top", 0}).size();
  for (std::uint64_t i = 0; i < count; ++i) {
    const GltfPlace place{"buffer", i};
    const Json& buffer = gltf_object(document.root, "buffers", place);
    const std::uint64_t length = unsigned_member(buffer, "byteLength", place);
    const std::string* uri = inner_uri(buffer, place);
    if (uri == nullptr && !(i == 0 && chunks.has_binary)) refuse(Code::file_truncated, place, "has no data");
    const auto data = uri != nullptr ? data_of(*uri, place, document) : chunks.binary;
    if (length > data.size()) {
      refuse(Code::file_truncated, place,
             "byteLength " + std::to_string(length) + ", but there are " + std::to_string(data.size()) +
                 " bytes");
    }
    document.buffers.push_back(data.first(length));
  }
}

void check_images(const Json& root) {
  const std::size_t count = array_member(root, "images", {"top", 0}).size();
  for (std::uint64_t i = 0; i < count; ++i)
    inner_uri(gltf_object(root, "images", {"image", i}), {"image", i});
}

}  // namespace

void refuse(Code code, const GltfPlace& place, std::string_view text) {
  throw Failure(
      {code, place.index,
       "glTF " + std::string(place.kind) + " " + std::to_string(place.index) + ": " + std::string(text)});
}

const Json& gltf_object(const Json& root, const char* array, const GltfPlace& place) {
  const Json& all = array_member(root, array, place);
  if (place.index >= all.size()) {
    refuse(Code::bad_index, place, "is not there, the file has " + std::to_string(all.size()));
  }
  const Json& object = all[place.index];
  if (!object.is_object()) refuse(Code::file_format, place, "is no object");
  return object;
}

const Json& array_member(const Json& object, const char* key, const GltfPlace& place) {
  static const Json empty = Json::array();
  const auto member = object.find(key);
  if (member == object.end()) return empty;
  if (!member->is_array()) refuse(Code::file_format, place, std::string(key) + " is no array");
  return *member;
}

std::uint64_t unsigned_member(const Json& object, const char* key, const GltfPlace& place,
                              std::optional<std::uint64_t> fallback) {
  const auto member = object.find(key);
  if (member == object.end()) {
    if (!fallback) refuse(Code::file_format, place, std::string("has no ") + key);
    return *fallback;
  }
  if (!member->is_number_unsigned())
    refuse(Code::file_format, place, std::string(key) + " is no whole number from 0 up");
  return member->get<std::uint64_t>();
}

bool numbers_member(const Json& object, const char* key, const GltfPlace& place, std::span<double> values) {
  if (!object.contains(key)) return false;
  const Json& array = array_member(object, key, place);
  if (array.size() != values.size()) {
    refuse(Code::file_format, place,
           std::string(key) + " needs " + std::to_string(values.size()) + " numbers");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!array[i].is_number()) refuse(Code::file_format, place, std::string(key) + " has what is no number");
    values[i] = array[i].get<double>();
    if (!std::isfinite(values[i])) refuse(Code::not_finite, place, std::string(key) + " is not finite");
  }
  return true;
}

GltfDocument open_gltf(std::span<const std::byte> bytes) {
  const bool binary = begins_with(bytes, "glTF");
  Chunks chunks;
  chunks.json = bytes;
  if (binary) chunks = split_glb(bytes);
  GltfDocument document;
  document.root = parse_json(chunks.json, chunks.json_offset);
  check_asset(document.root);
  check_images(document.root);
  open_buffers(document, chunks);
  return document;
}

}  // namespace cdfr
