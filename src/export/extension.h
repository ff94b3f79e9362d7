/// What a file's name says about its format.
#pragma once

#include <filesystem>
#include <string>

namespace cdfr {

/// The extension in lower case with its dot; ".STL" and ".stl" are one format.
inline std::string format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& letter : extension) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return extension;
}

}  // namespace cdfr
