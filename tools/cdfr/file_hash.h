/// A file's fingerprint.
#pragma once

#include <filesystem>
#include <string>

namespace cdfr::command {

/// SHA-256 of the bytes, as 64 hexadecimal digits. Ends the program (Stop) if the file cannot be read, or on
/// a signal.
std::string sha256_of(const std::filesystem::path& path);

}  // namespace cdfr::command
