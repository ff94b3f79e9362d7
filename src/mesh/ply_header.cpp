#include "mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/text.h"

namespace cdfr {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> type_names = {{{"char", PlyType::int8},
                                                  {"int8", PlyType::int8},
                                                  {"uchar", PlyType::uint8},
                                                  {"uint8", PlyType::uint8},
                                                  {"short", PlyType::int16},
                                                  {"int16", PlyType::int16},
                                                  {"ushort", PlyType::uint16},
                                                  {"uint16", PlyType::uint16},
                                                  {"int", PlyType::int32},
                                                  {"int32", PlyType::int32},
                                                  {"uint", PlyType::uint32},
                                                  {"uint32", PlyType::uint32},
                                                  {"float", PlyType::float32},
                                                  {"float32", PlyType::float32},
                                                  {"double", PlyType::float64},
                                                  {"float64", PlyType::float64}}};

bool is_integer(PlyType type) noexcept { return type != PlyType::float32 && type != PlyType::float64; }

std::optional<PlyType> type_named(std::string_view name) noexcept {
  for (const auto& entry : type_names) {
    if (entry.name == name) return entry.type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  explicit HeaderReader(std::span<const std::byte> bytes) noexcept : text_(bytes), size_(bytes.size()) {}

  Result<PlyHeader> read() {
    if (text_.word() != "ply") return fault("file does not begin with ply");
    while (text_.next_line()) {
      const auto keyword = text_.word();
      if (keyword == "end_header") return finish();
      if (auto done = read_line(keyword); !done) return done.error();
    }
    return error_at_line(Code::file_truncated, text_.line(), "PLY ends inside its header");
  }

 private:
  Result<void> read_line(std::string_view keyword) {
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return {};
    if (keyword == "format") return read_format();
    if (keyword == "element") return read_element();
    if (keyword == "property") return read_property();
    return fault("PLY header has the unknown keyword " + in_quotes(keyword));
  }

  Result<void> read_format() {
    const auto name = text_.word();
    const auto version = text_.word();
    if (has_format_) return fault("PLY header has two formats");
    if (name == "ascii") {
      header_.format = PlyFormat::ascii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::big_endian;
    } else {
      return fault("PLY format " + in_quotes(name) + " is not known");
    }
    if (version != "1.0") {
      return error_at_line(Code::file_version, text_.line(),
                           "PLY version " + in_quotes(version) + " is not 1.0");
    }
    has_format_ = true;
    return {};
  }

  Result<void> read_element() {
    const auto name = text_.word();
    const auto count = parse_integer(text_.word());
    if (name.empty() || !count || *count < 0) return fault("PLY element needs a name and a count");
    if (header_.find(name) != nullptr) return fault("PLY element " + in_quotes(name) + " is there twice");
    header_.elements.push_back({std::string(name), static_cast<std::uint64_t>(*count), {}});
    return {};
  }

  Result<void> read_property() {
    if (header_.elements.empty()) return fault("PLY property before any element");
    PlyProperty property;
    auto word = text_.word();
    if (word == "list") {
      property.count_type = type_named(text_.word());
      if (!property.count_type || !is_integer(*property.count_type)) {
        return fault("PLY list needs an integer type for its count");
      }
      word = text_.word();
    }
    const auto type = type_named(word);
    if (!type) return fault("PLY type " + in_quotes(word) + " is not known");
    property.type = *type;
    property.name = text_.word();
    if (property.name.empty()) return fault("PLY property has no name");
    auto& properties = header_.elements.back().properties;
    const auto same_name = [&](const PlyProperty& other) { return other.name == property.name; };
    if (std::any_of(properties.begin(), properties.end(), same_name)) {
      return fault("PLY property " + in_quotes(property.name) + " is there twice");
    }
    properties.push_back(std::move(property));
    return {};
  }

  Result<PlyHeader> finish() {
    if (!has_format_) return fault("PLY header has no format");
    for (const auto& element : header_.elements) {
      if (element.properties.empty() && element.count > 0) {
        return fault("PLY element " + in_quotes(element.name) + " has no properties");
      }
    }
    if (!text_.next_line()) {
      // The line end may only be missing where nothing has to follow it.
      for (const auto& element : header_.elements) {
        if (element.count > 0)
          return error_at_line(Code::file_truncated, text_.line(), "PLY ends with its header");
      }
    }
    header_.body = size_ - text_.remaining();
    header_.body_line = text_.line();
    return std::move(header_);
  }

  Error fault(std::string_view text) const { return error_at_line(Code::file_format, text_.line(), text); }

  TextReader text_;
  std::size_t size_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

std::size_t size_of(PlyType type) noexcept {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

const PlyElement* PlyHeader::find(std::string_view name) const noexcept {
  for (const auto& element : elements) {
    if (element.name == name) return &element;
  }
  return nullptr;
}

Result<PlyHeader> read_ply_header(std::span<const std::byte> bytes) { return HeaderReader(bytes).read(); }

}  // namespace cdfr
