/// A run of values that does not grow, wherever it lies: in a vector that it has taken over, or in a mapped
/// file.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace cdfr {

/// Copies share the values.
template <class T>
class Array {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;

  Array() = default;
  /// Takes over any kind of vector.
  template <class Vector>
  requires std::is_same_v<typename Vector::value_type, T> Array(Vector values) {
    auto kept = std::make_shared<Vector>(std::move(values));
    data_ = kept->data();
    size_ = kept->size();
    writable_ = true;
    owner_ = std::move(kept);
  }
  /// `owner` keeps the values where they are.
  Array(const T* data, std::size_t size, std::shared_ptr<const void> owner) noexcept
      : data_(data), size_(size), owner_(std::move(owner)) {}

  std::size_t size() const noexcept { return size_; }
  bool empty() const noexcept { return size_ == 0; }
  const T* data() const noexcept { return data_; }
  const T* begin() const noexcept { return data_; }
  const T* end() const noexcept { return data_ + size_; }
  const T& operator[](std::size_t i) const noexcept {
    assert(i < size_);
    return data_[i];
  }
  operator std::span<const T>() const noexcept { return {data_, size_}; }
  const T& front() const noexcept { return (*this)[0]; }
  const T& back() const noexcept { return (*this)[size_ - 1]; }

  /// Shares the values. Precondition: they are there.
  Array part(std::size_t first, std::size_t count) const noexcept {
    assert(first <= size_ && count <= size_ - first);
    Array shared = *this;
    shared.data_ += first;
    shared.size_ = count;
    return shared;
  }

  /// To change values while a field is made. Precondition: taken over from a vector.
  std::span<T> edit() noexcept {
    assert(writable_ || size_ == 0);
    return {const_cast<T*>(data_), size_};
  }

  std::uint64_t bytes() const noexcept { return size_ * sizeof(T); }

 private:
  const T* data_ = nullptr;
  std::size_t size_ = 0;
  bool writable_ = false;
  std::shared_ptr<const void> owner_;
};

}  // namespace cdfr
