#include "terminal_text.h"

#include <cstddef>

namespace cdfr::command {
namespace {

struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;  ///< 0: not UTF-8
};

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// The character that `text` begins with; overlong forms, surrogates and what lies beyond Unicode are not
/// UTF-8.
Character first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  char32_t code = lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if (!continues(text[i])) return {};
    code = code << 6U | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  const char32_t least = bytes == 4 ? 0x10000 : bytes == 3 ? 0x800 : 0x80;
  if (code < least || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
  return {code, bytes};
}

bool steers(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  return code < 0x20 || within(0x7F, 0x9F) || code == 0x061C || within(0x200E, 0x200F) ||
         within(0x2028, 0x202E) || within(0x2066, 0x2069) || code == 0xFEFF;
}

std::string hexadecimal(char32_t value, int digits) {
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) text += "0123456789abcdef"[value >> shift & 15];
  return text;
}

}  // namespace

std::string terminal_text(std::string_view foreign) {
  std::string shown;
  while (!foreign.empty()) {
    const Character next = first_character(foreign);
    const std::size_t taken = next.bytes == 0 ? 1 : next.bytes;
    if (next.bytes == 0) {
      shown += "\\x" + hexadecimal(static_cast<unsigned char>(foreign[0]), 2);
    } else if (steers(next.code)) {
      shown += next.code < 0x100 ? "\\x" + hexadecimal(next.code, 2) : "\\u" + hexadecimal(next.code, 4);
    } else {
      shown += foreign.substr(0, taken);
    }
    foreign.remove_prefix(taken);
  }
  return shown;
}

}  // namespace cdfr::command
