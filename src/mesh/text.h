/// Words, lines and numbers of a text file, without a copy and without the locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cdfr/core/result.h"

namespace cdfr {

/// Walks through text word by word and counts its lines. Line ends are LF or CRLF.
class TextReader {
 public:
  explicit TextReader(std::span<const std::byte> bytes) noexcept
      : at_(reinterpret_cast<const char*>(bytes.data())), end_(at_ + bytes.size()) {}

  /// Number of the current line, from 1.
  std::uint64_t line() const noexcept { return line_; }
  bool at_end() const noexcept { return at_ == end_; }
  std::size_t remaining() const noexcept { return static_cast<std::size_t>(end_ - at_); }

  /// The next word on this line; empty at the end of the line or text.
  std::string_view word() noexcept {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    const char* first = at_;
    while (at_ != end_ && *at_ != '\n' && !is_blank(*at_)) ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
  }

  /// The next word on this line or a later one; empty at the end of the text.
  std::string_view word_on_any_line() noexcept {
    std::string_view next = word();
    while (next.empty() && next_line()) next = word();
    return next;
  }

  /// What is left of this line, without blanks at either side.
  std::string_view rest_of_line() noexcept {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    const char* first = at_;
    while (at_ != end_ && *at_ != '\n') ++at_;
    const char* last = at_;
    while (last != first && is_blank(last[-1])) --last;
    return {first, static_cast<std::size_t>(last - first)};
  }

  /// To the start of the next line; false if the text ends first.
  bool next_line() noexcept {
    while (at_ != end_ && *at_ != '\n') ++at_;
    if (at_ == end_) return false;
    ++at_;
    ++line_;
    return true;
  }

  /// Nothing but blanks up to the end of this line.
  bool at_line_end() noexcept {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    return at_ == end_ || *at_ == '\n';
  }

 private:
  static bool is_blank(char c) noexcept {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }

  const char* at_;
  const char* end_;
  std::uint64_t line_ = 1;
};

/// Reads the whole word as a decimal number into `value`; a point is a point in every locale.
/// Returns what is wrong: file_format (no number), not_finite, or out_of_range (see coordinate.h).
std::optional<Code> parse_coordinate(std::string_view word, double& value) noexcept;

/// The whole word as a decimal integer, or nothing.
std::optional<std::int64_t> parse_integer(std::string_view word) noexcept;

/// A foreign word fit for a one-line message: cut to 40 characters, with '?' for what is not printable ASCII.
std::string in_quotes(std::string_view word);

bool equal_ignoring_case(std::string_view a, std::string_view b) noexcept;

bool begins_with(std::span<const std::byte> bytes, std::string_view magic) noexcept;

/// "line 12: " + text, with where = 12.
Error error_at_line(Code code, std::uint64_t line, std::string_view text);

}  // namespace cdfr
