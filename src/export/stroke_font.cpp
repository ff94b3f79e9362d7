#include "export/stroke_font.h"

#include <array>
#include <cstddef>

namespace cdfr {
namespace {

constexpr double letter_width = 4, letter_height = 6, advance = 5.5;

// Each letter on a grid 4 wide, as lines through points: a digit for x, a letter for y, with c on the base
// line, g on top of small letters, i of capitals, and a at the end of tails. A blank lifts the pen.
constexpr std::array<std::string_view, 95> glyphs{
    "",                                  // blank
    "2i2e 2d2c",                         // !
    "1i1g 3i3g",                         // "
    "1d1h 3d3h 0e4e 0g4g",               // #
    "4h1h0g1f3f4e3d0d 2i2c",             // $
    "0c4i 0i1i1h0h0i 3d4d4c3c3d",        // %
    "4c1g1h2i3h3g0e0d1c2c4e",            // &
    "2i2g",                              // '
    "3i2h2d3c",                          // (
    "1i2h2d1c",                          // )
    "2h2d 0g4e 0e4g",                    // *
    "2h2d 0f4f",                         // +
    "2d2c1b",                            // ,
    "1f3f",                              // -
    "2d2c",                              // .
    "0c4i",                              // /
    "1c0d0h1i3i4h4d3c1c",                // 0
    "1h2i2c 1c3c",                       // 1
    "0h1i3i4h4g0c4c",                    // 2
    "0h1i3i4h4g3f4e4d3c1c0d 2f3f",       // 3
    "3c3i0e4e",                          // 4
    "4i0i0f3f4e4d3c1c0d",                // 5
    "4h3i1i0h0d1c3c4d4e3f0f",            // 6
    "0i4i1c",                            // 7
    "1f0g0h1i3i4h4g3f1f0e0d1c3c4d4e3f",  // 8
    "0d1c3c4d4h3i1i0h0g1f4f",            // 9
    "2g2f 2d2c",                         // :
    "2g2f 2d2c1b",                       // ;
    "4h0f4d",                            // <
    "0g4g 0e4e",                         // =
    "0h4f0d",                            // >
    "0h1i3i4h4g2f2e 2d2c",               // ?
    "3e3g1g1e4e4h3i1i0h0d1c4c",          // @
    "0c0g2i4g4c 0e4e",                   // A
    "0c0i3i4h4g3f4e4d3c0c 0f3f",         // B
    "4h3i1i0h0d1c3c4d",                  // C
    "0c0i2i4g4e2c0c",                    // D
    "4i0i0c4c 0f3f",                     // E
    "4i0i0c 0f3f",                       // F
    "4h3i1i0h0d1c3c4d4f2f",              // G
    "0c0i 4c4i 0f4f",                    // H
    "1c3c 1i3i 2c2i",                    // I
    "0d1c3c4d4i",                        // J
    "0c0i 4i0f4c",                       // K
    "0i0c4c",                            // L
    "0c0i2f4i4c",                        // M
    "0c0i4c4i",                          // N
    "2c0e0g2i4g4e2c",                    // O
    "0c0i3i4h4g3f0f",                    // P
    "2c0e0g2i4g4e2c 3d4c",               // Q
    "0c0i3i4h4g3f0f 2f4c",               // R
    "0d1c3c4d4e3f1f0g0h1i3i4h",          // S
    "0i4i 2i2c",                         // T
    "0i0d1c3c4d4i",                      // U
    "0i2c4i",                            // V
    "0i1c2f3c4i",                        // W
    "0c4i 0i4c",                         // X
    "0i2f4i 2f2c",                       // Y
    "0i4i0c4c",                          // Z
    "3i1i1c3c",                          // [
    "0i4c",                              // backslash
    "1i3i3c1c",                          // ]
    "0g2i4g",                            // ^
    "0b4b",                              // _
    "1i2h",                              // `
    "0g3g4f4c1c0d1e4e",                  // a
    "0i0c3c4d4f3g0g",                    // b
    "4g1g0f0d1c4c",                      // c
    "4i4c1c0d0f1g4g",                    // d
    "0e4e4f3g1g0f0d1c4c",                // e
    "4i3i2h2c 0g4g",                     // f
    "4c1c0d0f1g4g4b3a0a",                // g
    "0i0c 0g3g4f4c",                     // h
    "1g2g2c 1c3c 2h2i",                  // i
    "1g2g2b1a0a 2h2i",                   // j
    "0i0c 3g0e4c",                       // k
    "1i2i2d3c",                          // l
    "0c0g3g4f4c 2g2c",                   // m
    "0c0g3g4f4c",                        // n
    "1c0d0f1g3g4f4d3c1c",                // o
    "0a0g3g4f4d3c0c",                    // p
    "4a4g1g0f0d1c4c",                    // q
    "0c0g 0f1g4g",                       // r
    "4g1g0f1e3e4d3c0c",                  // s
    "1i1d2c4c 0g4g",                     // t
    "0g0d1c4c 4g4c",                     // u
    "0g2c4g",                            // v
    "0g1c2f3c4g",                        // w
    "0g4c 0c4g",                         // x
    "0g0d1c4c 4g4b3a0a",                 // y
    "0g4g0c4c",                          // z
    "3i2h2g1f2e2d3c",                    // {
    "2i2b",                              // |
    "1i2h2g3f2e2d1c",                    // }
    "0f1g3e4f",                          // ~
};
constexpr std::string_view unknown = "0c0i4i4c0c";

std::string_view glyph_of(char letter) noexcept {
  const auto place = static_cast<std::size_t>(static_cast<unsigned char>(letter)) - ' ';
  return place < glyphs.size() ? glyphs[place] : unknown;
}

/// Bytes of UTF-8 after the first one of a character.
bool continues(char byte) noexcept { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80; }

void append_glyph(std::string_view glyph, double left, std::vector<Stroke>& strokes) {
  const auto x = [&](std::size_t i) { return (left + (glyph[i] - '0')) / letter_height; };
  const auto y = [&](std::size_t i) { return (glyph[i + 1] - 'c') / letter_height; };
  for (std::size_t i = 0; i + 3 < glyph.size();) {
    const bool lifts = glyph[i + 2] == ' ';
    if (!lifts) strokes.push_back({x(i), y(i), x(i + 2), y(i + 2)});
    i += lifts ? 3 : 2;
  }
}

}  // namespace

std::vector<Stroke> strokes_of(std::string_view text) {
  std::vector<Stroke> strokes;
  double left = 0;
  for (const char letter : text) {
    if (continues(letter)) continue;
    append_glyph(glyph_of(letter), left, strokes);
    left += advance;
  }
  return strokes;
}

double text_width(std::string_view text) noexcept {
  double letters = 0;
  for (const char letter : text) letters += continues(letter) ? 0 : 1;
  return letters == 0 ? 0 : ((letters - 1) * advance + letter_width) / letter_height;
}

}  // namespace cdfr
