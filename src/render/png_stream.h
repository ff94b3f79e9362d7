/// A PNG, row by row.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "cdfr/core/result.h"
#include "core/whole_file.h"

namespace cdfr {

/// 8 bits a channel, RGB, without a time stamp: equal pictures have equal bytes. Errors: file_write.
class PngStream {
 public:
  /// The file must outlive the stream and is finished by the caller. Precondition: sizes are positive.
  static Result<PngStream> begin(WholeFile& file, int width, int height);
  /// Precondition: 3 * width bytes; called `height` times.
  Result<void> write_row(std::span<const std::uint8_t> row);
  Result<void> end();

 private:
  struct State;
  struct Close {
    void operator()(State* state) const noexcept;
  };
  explicit PngStream(std::unique_ptr<State, Close> state) noexcept : state_(std::move(state)) {}

  std::unique_ptr<State, Close> state_;
};

}  // namespace cdfr
