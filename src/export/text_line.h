/// Foreign text on one line of a file.
#pragma once

#include <string>
#include <string_view>

namespace cdfr {

/// Control characters become blanks; every other byte stays.
inline std::string text_line(std::string_view text) {
  std::string line(text);
  for (char& letter : line) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x20 || byte == 0x7f) letter = ' ';
  }
  return line;
}

}  // namespace cdfr
