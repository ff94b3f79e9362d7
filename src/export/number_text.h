/// Numbers as text that no locale changes.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <string>

namespace cdfr {

/// 17 significant digits: the same double comes back, and every table shows the same number of digits.
inline void append_number(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 17);
  text.append(digits.data(), end.ptr);
}

template <std::unsigned_integral Number>
void append_number(std::string& text, Number value) {
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end.ptr);
}

}  // namespace cdfr
