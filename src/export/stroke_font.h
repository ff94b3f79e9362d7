/// Text as straight strokes, for files that know no letters.
#pragma once

#include <string_view>
#include <vector>

namespace cdfr {

/// From (x0, y0) to (x1, y1).
struct Stroke {
  double x0, y0, x1, y1;
};

/// Strokes of one line that begins at the origin, its capitals 1 high and its tails down to -1/3. Every
/// letter is as wide as every other. Of UTF-8 printable ASCII is drawn, any other character as an empty box.
std::vector<Stroke> strokes_of(std::string_view text);

/// From the first letter's left edge to the last one's right edge; 0 for no text.
double text_width(std::string_view text) noexcept;

}  // namespace cdfr
