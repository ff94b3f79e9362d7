/// Foreign text made safe for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace cdfr::command {

/// Printable UTF-8 stays as it is. Control characters, line and paragraph separators, marks that turn the
/// direction of writing, and bytes that are no UTF-8 become \x1b or \u202e: what is shown is one line, and
/// steers nothing.
std::string terminal_text(std::string_view foreign);

}  // namespace cdfr::command
