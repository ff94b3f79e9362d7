/// The head of a PLY file: which elements with which properties follow, and how they are written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cdfr/core/result.h"

namespace cdfr {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type) noexcept;

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;      ///< of the value, or of each value of a list
  std::optional<PlyType> count_type{};  ///< set for a list; an integer type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;         ///< byte after the line end_header
  std::uint64_t body_line = 0;  ///< its line number

  /// Null if there is none of this name.
  const PlyElement* find(std::string_view name) const noexcept;
};

/// Checks the header by itself: known format and types, every element with properties, no element twice.
Result<PlyHeader> read_ply_header(std::span<const std::byte> bytes);

}  // namespace cdfr
