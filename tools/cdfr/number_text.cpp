#include "number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "unit.h"

namespace cdfr::command {
namespace {

std::string rounded(double value, std::chars_format format, int precision) {
  std::array<char, 400> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision).ptr;
  return {buffer.data(), end};
}

/// A number as d.ddd * 10^exponent. Precondition: finite, not 0.
struct Decimal {
  int first_digit, exponent;
};

Decimal decimal(double value) {
  const std::string text = rounded(std::abs(value), std::chars_format::scientific, 16);
  return {text.front() - '0', std::stoi(text.substr(text.find('e') + 1))};
}

double parsed(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Place of the last digit that is worth showing, as a power of ten.
int last_place(double value, double error) {
  constexpr int most_digits = 9;
  const auto [digit, exponent] = decimal(error);
  const int place = digit < 3 ? exponent - 1 : exponent;
  return value == 0 ? place : std::max(place, decimal(value).exponent - (most_digits - 1));
}

/// Rounded to whole steps of `step`, which is 10^place.
std::string text_to_place(double value, double step, int place) {
  constexpr double widest = 1e15;
  constexpr int most_decimals = 9;
  if (std::abs(value) < widest && place >= -most_decimals) {
    const double whole = place > 0 ? std::round(value / step) * step : value;
    const std::string text = rounded(whole, std::chars_format::fixed, std::max(0, -place));
    return parsed(text) == 0 ? rounded(0, std::chars_format::fixed, std::max(0, -place)) : text;
  }
  const int digits = value == 0 ? 0 : std::max(0, decimal(value).exponent - place);
  return rounded(value, std::chars_format::scientific, digits);
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

std::string bounded_text(double value, double error, const std::string& unit) {
  if (!std::isfinite(value)) return "unknown";
  const std::string label = after_number(unit);
  if (!std::isfinite(error)) return short_text(value) + label + " +- unknown";
  std::string text;
  if (!(error > 0)) {
    append_exact(text, value);
    return text + label + " +- 0";
  }
  constexpr double forgiven = 1e-12;
  const int place = last_place(value, error);
  const double step = parsed("1e" + std::to_string(place));
  text = text_to_place(value, step, place);
  const double off = std::abs(value - parsed(text));
  const double steps = std::ceil((error + off) / step * (1 - forgiven));
  return text + label + " +- " + text_to_place(steps * step, step, place);
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
