// Points as NPY: an (n,3) array of f4 or f8, little endian, C or Fortran order.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/bytes.h"
#include "mesh/coordinate.h"
#include "mesh/readers.h"
#include "mesh/text.h"

namespace cdfr {
namespace {

struct Layout {
  std::size_t item_size = 8;
  bool fortran_order = false;
  std::uint64_t count = 0;
};

Error fault(Code code, std::uint64_t byte, const std::string& text) {
  return {code, byte, "byte " + std::to_string(byte) + ": " + text};
}

/// What stands after `'key':` in the Python dictionary of the header, up to its comma, bracket or brace.
std::string_view value_of(std::string_view header, std::string_view key) noexcept {
  const auto found = header.find("'" + std::string(key) + "'");
  if (found == header.npos) return {};
  header.remove_prefix(found + key.size() + 2);
  const auto first = header.find_first_not_of(" :");
  if (first == header.npos) return {};
  header.remove_prefix(first);
  const bool tuple = header.starts_with('(');
  const auto end = header.find_first_of(tuple ? ")" : ",}");
  return header.substr(0, end == header.npos ? end : end + (tuple ? 1 : 0));
}

/// The n of "(n, 3)".
std::optional<std::uint64_t> rows_of(std::string_view shape) noexcept {
  if (!shape.starts_with('(') || !shape.ends_with(')')) return std::nullopt;
  const auto comma = shape.find(',');
  if (comma == shape.npos) return std::nullopt;
  const auto rows = parse_integer(shape.substr(1, comma - 1));
  auto columns = shape.substr(comma + 1, shape.size() - comma - 2);
  while (columns.starts_with(' ')) columns.remove_prefix(1);
  if (!rows || *rows < 0 || columns != "3") return std::nullopt;
  return static_cast<std::uint64_t>(*rows);
}

Result<Layout> read_header(std::string_view header, std::uint64_t at) {
  Layout layout;
  const auto descr = value_of(header, "descr");
  if (descr == "'<f4'") {
    layout.item_size = 4;
  } else if (descr != "'<f8'") {
    return fault(Code::file_format, at, "NPY type " + in_quotes(descr) + " is not '<f4' or '<f8'");
  }
  const auto order = value_of(header, "fortran_order");
  if (order != "True" && order != "False") return fault(Code::file_format, at, "NPY has no fortran_order");
  layout.fortran_order = order == "True";
  const auto shape = value_of(header, "shape");
  const auto rows = rows_of(shape);
  if (!rows) return fault(Code::file_format, at, "NPY shape " + in_quotes(shape) + " is not (n, 3)");
  if (*rows >= no_index) return fault(Code::out_of_range, at, "NPY has more than 2^32 - 2 points");
  layout.count = *rows;
  return layout;
}

Result<std::vector<Vec3>> read_rows(std::span<const std::byte> data, const Layout& layout) {
  std::vector<Vec3> points(layout.count);
  const auto value = [&](std::uint64_t row, std::uint64_t column) -> double {
    const std::uint64_t place = layout.fortran_order ? column * layout.count + row : 3 * row + column;
    const std::byte* at = data.data() + place * layout.item_size;
    return layout.item_size == 4 ? load_little<float>(at) : load_little<double>(at);
  };
  for (std::uint64_t i = 0; i < layout.count; ++i) {
    points[i] = {value(i, 0), value(i, 1), value(i, 2)};
    if (const auto wrong = coordinate_fault(points[i])) {
      return Error{*wrong, i, "point " + std::to_string(i) + " " + coordinate_fault_text(*wrong)};
    }
  }
  return points;
}

}  // namespace

Result<std::vector<Vec3>> read_npy(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  reader.take(6);  // the magic, by which the file was known
  const auto major = reader.little<std::uint8_t>();
  const auto minor = reader.little<std::uint8_t>();
  if (!major || !minor) return fault(Code::file_truncated, bytes.size(), "NPY ends inside its header");
  if (*major < 1 || *major > 3) {
    return fault(Code::file_version, 6, "NPY version " + std::to_string(*major) + " is not 1, 2 or 3");
  }
  std::optional<std::uint32_t> length;
  if (*major == 1) {
    if (const auto small = reader.little<std::uint16_t>()) length = *small;
  } else {
    length = reader.little<std::uint32_t>();
  }
  const std::uint64_t at = reader.offset();
  const auto header = length ? reader.take(*length) : std::nullopt;
  if (!header) return fault(Code::file_truncated, bytes.size(), "NPY ends inside its header");
  const auto layout = read_header({reinterpret_cast<const char*>(header->data()), header->size()}, at);
  if (!layout) return layout.error();
  const std::uint64_t size = 3 * layout->count * layout->item_size;
  if (reader.remaining() != size) {
    return fault(reader.remaining() < size ? Code::file_truncated : Code::file_format, reader.offset(),
                 "NPY array needs " + std::to_string(size) + " bytes, the file has " +
                     std::to_string(reader.remaining()));
  }
  return read_rows(*reader.take(size), *layout);
}

}  // namespace cdfr
