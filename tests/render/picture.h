/// A PNG read back by libpng's own reader.
#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace cdfr {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  explicit Picture(const std::filesystem::path& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << image.message;
    image.format = PNG_FORMAT_RGB;
    width = static_cast<int>(image.width);
    height = static_cast<int>(image.height);
    rgb.resize(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0) << image.message;
    png_image_free(&image);
  }

  std::array<int, 3> at(int column, int row) const {
    const std::size_t i = 3 * (std::size_t(row) * std::size_t(width) + std::size_t(column));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
  bool white(int column, int row) const { return at(column, row) == std::array<int, 3>{255, 255, 255}; }
  /// The colour of points, also through the part.
  bool warm(int column, int row) const { return at(column, row)[0] > at(column, row)[2] + 40; }

  int count_warm() const {
    int count = 0;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) count += warm(column, row) ? 1 : 0;
    }
    return count;
  }
};

}  // namespace cdfr
