/// A strided read-only view of coordinates, so that vectors, numpy rows and Eigen rows fit without a copy.
#pragma once

#include <cstddef>
#include <span>

#include "cdfr/core/types.h"

namespace cdfr {

/// Borrowed: the memory must outlive the view. Copying the view is free.
class Points {
 public:
  Points() noexcept = default;
  Points(std::span<const Vec3> points) noexcept
      : data_(reinterpret_cast<const double*>(points.data())), size_(points.size()) {}
  /// `count` points; the coordinates of point i are data[i*stride], data[i*stride + 1], data[i*stride + 2].
  explicit Points(const double* data, std::size_t count, std::size_t stride = 3) noexcept
      : data_(data), size_(count), stride_(stride) {}

  std::size_t size() const noexcept { return size_; }
  bool empty() const noexcept { return size_ == 0; }
  /// Precondition: i < size().
  Vec3 operator[](std::size_t i) const noexcept {
    const double* p = data_ + i * stride_;
    return {p[0], p[1], p[2]};
  }

 private:
  const double* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t stride_ = 3;
};

}  // namespace cdfr
