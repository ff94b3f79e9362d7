#include "mesh/text.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "mesh/coordinate.h"

namespace cdfr {
namespace {

constexpr std::size_t longest_quote = 40;

std::string_view without_plus(std::string_view word) noexcept {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

char lower(char c) noexcept { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool has_digit(std::string_view word) noexcept { return word.find_first_of("0123456789") != word.npos; }

/// True for a number that was written with digits other than 0 and came out as 0.
bool underflowed(std::string_view word, double value) noexcept {
  if (value != 0) return false;
  for (const char c : word) {
    if (c == 'e' || c == 'E') return false;
    if (c >= '1' && c <= '9') return true;
  }
  return false;
}

}  // namespace

std::optional<Code> parse_coordinate(std::string_view word, double& value) noexcept {
  word = without_plus(word);
  const auto [end, status] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return Code::file_format;
  if (status == std::errc::invalid_argument) return Code::file_format;
  // "1e999" comes out as infinity, but what is wrong with it is its size.
  if (status == std::errc::result_out_of_range) return Code::out_of_range;
  if (std::isinf(value) && has_digit(word)) return Code::out_of_range;
  if (underflowed(word, value)) return Code::out_of_range;
  return coordinate_fault(value);
}

std::optional<std::int64_t> parse_integer(std::string_view word) noexcept {
  word = without_plus(word);
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (status != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::string in_quotes(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, longest_quote)) text += c >= ' ' && c <= '~' ? c : '?';
  text += word.size() > longest_quote ? "...'" : "'";
  return text;
}

bool equal_ignoring_case(std::string_view a, std::string_view b) noexcept {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (lower(a[i]) != lower(b[i])) return false;
  }
  return true;
}

bool begins_with(std::span<const std::byte> bytes, std::string_view magic) noexcept {
  const auto* first = reinterpret_cast<const char*>(bytes.data());
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), first);
}

Error error_at_line(Code code, std::uint64_t line, std::string_view text) {
  return {code, line, "line " + std::to_string(line) + ": " + std::string(text)};
}

}  // namespace cdfr
