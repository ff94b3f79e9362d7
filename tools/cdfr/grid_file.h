/// Distances of a grid as a file that other programs read.
#pragma once

#include <filesystem>
#include <span>

#include "cdfr/field/grid.h"

namespace cdfr::command {

/// The extension names the format: .npy (nz, ny, nx) or .vti, an image with the point data "distance". Hold
/// signals back meanwhile (whole_file).
void write_grid(const Grid& grid, std::span<const double> distances, const std::filesystem::path& path);

}  // namespace cdfr::command
