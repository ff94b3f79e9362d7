#include "number_text.h"

#include <array>
#include <charconv>

namespace cdfr::command {
namespace {

std::string rounded(double value, std::chars_format format, int precision) {
  std::array<char, 400> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision).ptr;
  return {buffer.data(), end};
}

}  // namespace

void append_exact(std::string& text, double value) {
  std::array<char, 32> buffer{};
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

std::string short_text(double value) { return rounded(value, std::chars_format::general, 9); }

std::string short_text(Vec3 value) {
  return "(" + short_text(value.x) + ", " + short_text(value.y) + ", " + short_text(value.z) + ")";
}

std::string count_text(std::uint64_t value) {
  std::string digits = std::to_string(value);
  for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3) {
    digits.insert(static_cast<std::size_t>(place), 1, ',');
  }
  return digits;
}

std::string seconds_text(double seconds) {
  if (seconds < 1) return rounded(seconds * 1000, std::chars_format::fixed, 0) + " ms";
  return rounded(seconds, std::chars_format::fixed, 1) + " s";
}

std::string bytes_text(std::uint64_t bytes) {
  if (bytes < 1024) return std::to_string(bytes) + " bytes";
  double size = static_cast<double>(bytes) / 1024;
  const char* unit = "KiB";
  for (const char* larger : {"MiB", "GiB", "TiB"}) {
    if (size < 1024) break;
    size /= 1024;
    unit = larger;
  }
  return rounded(size, std::chars_format::fixed, 1) + " " + unit;
}

}  // namespace cdfr::command
