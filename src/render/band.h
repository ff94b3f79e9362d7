/// The samples of some rows of the picture: what is nearest, and what is behind it.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace cdfr {

/// A piece of surface at one sample. The normal is a unit vector in the picture's directions, z not positive.
struct Sample {
  float depth = std::numeric_limits<float>::infinity();
  float nx = 0, ny = 0, nz = -1;

  bool empty() const noexcept { return depth == std::numeric_limits<float>::infinity(); }
};

/// One grid of samples: columns 0 .. width - 1, rows first_row .. first_row + rows - 1 of the whole picture.
class Layer {
 public:
  Layer(int width, int first_row, int rows)
      : width_(width), first_row_(first_row), rows_(rows), samples_(std::size_t(width) * std::size_t(rows)) {}

  int width() const noexcept { return width_; }
  int first_row() const noexcept { return first_row_; }
  int end_row() const noexcept { return first_row_ + rows_; }
  bool holds(int column, int row) const noexcept {
    return column >= 0 && column < width_ && row >= first_row_ && row < end_row();
  }
  /// Precondition: holds(column, row).
  Sample& at(int column, int row) noexcept { return samples_[index(column, row)]; }
  const Sample& at(int column, int row) const noexcept { return samples_[index(column, row)]; }

 private:
  std::size_t index(int column, int row) const noexcept {
    return std::size_t(row - first_row_) * std::size_t(width_) + std::size_t(column);
  }

  int width_, first_row_, rows_;
  std::vector<Sample> samples_;
};

struct Band {
  Band(int width, int first_row, int rows) : front(width, first_row, rows), back(front), points(front) {}

  Layer front;   ///< of the part: nearest
  Layer back;    ///< of the part: farthest
  Layer points;  ///< nearest splat
};

}  // namespace cdfr
