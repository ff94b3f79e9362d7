/// Distances of a grid as a file that other programs read.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "byte_sink.h"
#include "cdfr/field/grid.h"

namespace cdfr::command {

/// The extension names the format: .npy (nz, ny, nx) or .vti, an image with the point data "distance". Hold
/// signals back while it lives (whole_file).
class GridFile {
 public:
  GridFile(const Grid& grid, const std::filesystem::path& path);
  /// The next samples, x fastest.
  void write(std::span<const double> distances);
  /// Call once, after all samples. Without it nothing is left behind.
  void finish();

 private:
  bool is_image_;
  std::unique_ptr<ByteSink> sink_;
};

}  // namespace cdfr::command
