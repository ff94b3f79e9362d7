/// The numbers of a PLY body, one after another, in either notation. Both classes have the same shape:
///   most_rows            how many rows of an element the rest of the file can hold at most
///   start_row, end_row   bracket the values of one row
///   number, coordinate   the next value, an integer (of a list) or a coordinate
///   skip                 over so many values
/// They return false at an error, which `error` then describes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "cdfr/core/result.h"
#include "core/bytes.h"
#include "mesh/ply_header.h"
#include "mesh/text.h"

namespace cdfr {

class PlyBinary {
 public:
  PlyBinary(std::span<const std::byte> bytes, const PlyHeader& header) noexcept
      : reader_(bytes.subspan(header.body)),
        base_(header.body),
        order_(header.format == PlyFormat::big_endian ? std::endian::big : std::endian::little) {}

  std::uint64_t most_rows(const PlyElement& element) const noexcept {
    std::uint64_t least_size = 0;
    for (const auto& property : element.properties)
      least_size += size_of(property.count_type.value_or(property.type));
    return least_size == 0 ? std::numeric_limits<std::uint64_t>::max() : reader_.remaining() / least_size;
  }

  bool start_row() noexcept { return true; }
  bool end_row() noexcept { return true; }

  bool number(PlyType type, double& value) noexcept {
    const auto bytes = reader_.take(size_of(type));
    if (bytes) value = decode(bytes->data(), type);
    return bytes.has_value();
  }
  bool coordinate(PlyType type, double& value) noexcept { return number(type, value); }
  bool skip(PlyType type, std::uint64_t count) noexcept {
    return count <= reader_.remaining() && reader_.take(count * size_of(type)).has_value();
  }

  bool at_end() noexcept { return reader_.remaining() == 0; }
  Error error(const std::string& what) const {
    return fault(Code::file_truncated, what + " is cut off by the end of the file");
  }
  Error fault(Code code, const std::string& what) const {
    const std::uint64_t where = base_ + reader_.offset();
    return {code, where, "byte " + std::to_string(where) + ": " + what};
  }

 private:
  double decode(const std::byte* data, PlyType type) const noexcept {
    switch (type) {
      case PlyType::int8:
        return load<std::int8_t>(data, order_);
      case PlyType::uint8:
        return load<std::uint8_t>(data, order_);
      case PlyType::int16:
        return load<std::int16_t>(data, order_);
      case PlyType::uint16:
        return load<std::uint16_t>(data, order_);
      case PlyType::int32:
        return load<std::int32_t>(data, order_);
      case PlyType::uint32:
        return load<std::uint32_t>(data, order_);
      case PlyType::float32:
        return load<float>(data, order_);
      case PlyType::float64:
        break;
    }
    return load<double>(data, order_);
  }

  ByteReader reader_;
  std::size_t base_;
  std::endian order_;
};

/// One row a line; blank lines between rows are skipped.
class PlyAscii {
 public:
  PlyAscii(std::span<const std::byte> bytes, const PlyHeader& header) noexcept
      : text_(bytes.subspan(header.body)), line_offset_(header.body_line - 1) {}

  std::uint64_t most_rows(const PlyElement& element) const noexcept {
    // Each property takes at least a digit and a blank or line end; the last line end may be missing.
    const std::uint64_t least_size = 2 * element.properties.size();
    return least_size == 0 ? std::numeric_limits<std::uint64_t>::max() : (text_.remaining() + 1) / least_size;
  }

  bool start_row() noexcept {
    while (text_.at_line_end()) {
      if (!text_.next_line()) return false;
    }
    return true;
  }
  bool end_row() noexcept {
    const bool complete = text_.at_line_end();
    extra_ = complete ? std::string_view() : text_.word();
    if (complete) text_.next_line();
    return complete;
  }

  bool number(PlyType, double& value) noexcept {
    const auto word = text_.word();
    const auto integer = parse_integer(word);
    if (integer) value = static_cast<double>(*integer);
    return note(word, integer.has_value());
  }
  /// Leaves NaN, infinities and sizes that are not supported to the caller, who knows the vertex.
  bool coordinate(PlyType, double& value) noexcept {
    const auto word = text_.word();
    const auto wrong = parse_coordinate(word, value);
    if (wrong == Code::out_of_range) value = 0x1p300;  // an underflow would look like a good zero
    return note(word, wrong != Code::file_format);
  }
  bool skip(PlyType, std::uint64_t count) noexcept {
    for (; count > 0; --count) {
      if (const auto word = text_.word(); word.empty()) return note(word, false);
    }
    return true;
  }

  bool at_end() noexcept { return text_.word_on_any_line().empty(); }
  Error error(const std::string& what) const {
    if (!extra_.empty())
      return fault(Code::file_format, what + " has more values than its properties: " + in_quotes(extra_));
    if (!bad_.empty())
      return fault(Code::file_format, what + " has a value that is no number: " + in_quotes(bad_));
    if (text_.at_end()) return fault(Code::file_truncated, what + " is cut off by the end of the file");
    return fault(Code::file_format, what + " has too few values");
  }
  Error fault(Code code, const std::string& what) const {
    return error_at_line(code, line_offset_ + text_.line(), what);
  }

 private:
  bool note(std::string_view word, bool good) noexcept {
    if (!good) bad_ = word;
    return good;
  }

  TextReader text_;
  std::uint64_t line_offset_;
  std::string_view bad_;
  std::string_view extra_;
};

}  // namespace cdfr
