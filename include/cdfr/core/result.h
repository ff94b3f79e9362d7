/// A value or a named error, wherever foreign data enters. Test it, or call value() and get an exception.
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "cdfr/core/api.h"

namespace cdfr {

/// What went wrong, each one thing that a caller can act on.
enum class Code : int {
  bad_option = 1,   ///< an argument is outside its documented range
  empty_mesh,       ///< no triangle to measure to
  bad_index,        ///< an index points beyond its array
  not_finite,       ///< a coordinate is NaN or infinite
  out_of_range,     ///< a coordinate is outside 2^-200 .. 2^200, or a count beyond 2^32 - 2
  file_open,        ///< cannot be opened, or is no regular file
  file_format,      ///< the bytes are not what the format says
  file_version,     ///< written by a version that this one does not know
  file_truncated,   ///< ends before it should
  file_write,       ///< cannot be written, synced or renamed
  cancelled,        ///< the caller's tick said stop
  not_closed,       ///< the answer needs a closed mesh and this one is not
};

/// Short English name of a code. Never null; thread safe.
CDFR_API const char* code_text(Code code) noexcept;

/// `where` counts in what the text names: a byte, a line, a triangle or a vertex.
struct Error {
  Code code = Code::bad_option;
  std::uint64_t where = 0;
  std::string text;
};

/// Thrown by Result::value() when there is none.
class CDFR_API Failure : public std::runtime_error {
 public:
  explicit Failure(Error error) : std::runtime_error(error.text), error_(std::move(error)) {}
  const Error& error() const noexcept { return error_; }

 private:
  Error error_;
};

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Error error) : error_(std::move(error)) {}

  explicit operator bool() const noexcept { return value_.has_value(); }
  /// Throws Failure if there is no value.
  T& value() & { return check(), *value_; }
  const T& value() const& { return check(), *value_; }
  T&& value() && { return check(), std::move(*value_); }
  /// Precondition: the result holds a value.
  T& operator*() noexcept { return assert(value_), *value_; }
  const T& operator*() const noexcept { return assert(value_), *value_; }
  T* operator->() noexcept { return assert(value_), &*value_; }
  const T* operator->() const noexcept { return assert(value_), &*value_; }
  /// Precondition: the result holds an error.
  const Error& error() const noexcept { return assert(!value_), error_; }

 private:
  void check() const {
    if (!value_) throw Failure(error_);
  }
  std::optional<T> value_;
  Error error_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  explicit operator bool() const noexcept { return !error_; }
  void value() const {
    if (error_) throw Failure(*error_);
  }
  const Error& error() const noexcept { return assert(error_), *error_; }

 private:
  std::optional<Error> error_;
};

}  // namespace cdfr
