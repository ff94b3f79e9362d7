/// Where a table's bytes go: a file that is whole or not there, or standard output.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace cdfr::command {

/// Errors end the program with the target's name (Stop).
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  virtual void write(std::string_view bytes) = 0;
  /// Call once, last. Without it a file leaves nothing behind.
  virtual void finish() = 0;
};

/// Bytes go to a temporary file beside `path`, which finish() syncs and renames. Hold signals back
/// (DeferInterrupts) while it lives.
std::unique_ptr<ByteSink> whole_file(const std::filesystem::path& path);

std::unique_ptr<ByteSink> standard_output();

/// Text to standard output, and its errors: a full disk is no success.
void print_text(std::string_view text);

}  // namespace cdfr::command
