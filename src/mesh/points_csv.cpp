// Points as CSV: x,y,z in the first three columns of each line.
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "mesh/coordinate.h"
#include "mesh/csv_points.h"
#include "mesh/readers.h"
#include "mesh/text.h"

namespace cdfr {
namespace {

std::string_view trimmed(std::string_view field) noexcept {
  const auto first = field.find_first_not_of(" \t\r");
  if (first == field.npos) return {};
  return field.substr(first, field.find_last_not_of(" \t\r") - first + 1);
}

/// The first three fields, trimmed; false if there are fewer.
bool split(std::string_view line, std::array<std::string_view, 3>& fields) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto comma = line.find(',');
    if (comma == line.npos && k < 2) return false;
    fields[k] = trimmed(line.substr(0, comma));
    line.remove_prefix(comma == line.npos ? line.size() : comma + 1);
  }
  return true;
}

std::string_view unquoted(std::string_view field) noexcept {
  const bool quotes = field.size() >= 2 && field.front() == '"' && field.back() == '"';
  return quotes ? field.substr(1, field.size() - 2) : field;
}

bool is_header(const std::array<std::string_view, 3>& fields) noexcept {
  return equal_ignoring_case(unquoted(fields[0]), "x") && equal_ignoring_case(unquoted(fields[1]), "y") &&
         equal_ignoring_case(unquoted(fields[2]), "z");
}

}  // namespace

Result<void> CsvPoints::add_line(std::string_view line) {
  ++line_;
  if (line_ == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
  if (trimmed(line).empty()) return {};
  std::array<std::string_view, 3> fields;
  if (!split(line, fields)) {
    return error_at_line(Code::file_format, line_, "fewer than three columns: " + in_quotes(trimmed(line)));
  }
  const bool first = std::exchange(before_first_, false);
  if (first && is_header(fields)) return {};
  Vec3 point;
  const std::array<double*, 3> coordinates = {&point.x, &point.y, &point.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (const auto wrong = parse_coordinate(fields[k], *coordinates[k])) {
      const std::string hint =
          first && wrong == Code::file_format ? " (a header line would begin x,y,z)" : "";
      return error_at_line(
          *wrong, line_,
          std::string("point ") + coordinate_fault_text(*wrong) + ": " + in_quotes(fields[k]) + hint);
    }
  }
  if (points_.size() >= no_index - 1)
    return error_at_line(Code::out_of_range, line_, "more than 2^32 - 2 points");
  points_.push_back(point);
  return {};
}

Result<std::vector<Vec3>> read_csv(std::span<const std::byte> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  CsvPoints points;
  while (!text.empty()) {
    const auto end = text.find('\n');
    if (auto done = points.add_line(text.substr(0, end)); !done) return done.error();
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return std::move(points).take();
}

}  // namespace cdfr
