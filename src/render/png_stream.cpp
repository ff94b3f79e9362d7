/// libpng reports errors by a jump, which must not pass a destructor. So each group of its calls sits in a
/// function whose locals are trivial, and the callback never fails: it keeps the first error and ignores what
/// comes after it.
#include "render/png_stream.h"

#include <png.h>

#include <cassert>
#include <csetjmp>
#include <optional>

namespace cdfr {
namespace {

constexpr int compression_level = 6;

[[noreturn]] void jump_back(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void ignore_warning(png_structp, png_const_charp) {}
void ignore_flush(png_structp) {}

bool start(png_structp png, png_infop info, png_uint_32 width, png_uint_32 height) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
               PNG_FILTER_TYPE_BASE);
  png_set_compression_level(png, compression_level);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  return true;
}

bool add_row(png_structp png, png_const_bytep row) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_write_row(png, row);
  return true;
}

bool close(png_structp png) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

struct PngStream::State {
  explicit State(WholeFile& target) : file(target) {}

  static void keep_bytes(png_structp png, png_bytep bytes, png_size_t size) {
    auto& state = *static_cast<State*>(png_get_io_ptr(png));
    if (state.failed) return;
    const auto written = state.file.write(std::as_bytes(std::span(bytes, size)));
    if (!written) state.failed = written.error();
  }

  Result<void> outcome(bool good) {
    if (!good && !failed) failed = Error{Code::file_write, 0, "the PNG encoder failed"};
    return failed ? Result<void>(*failed) : Result<void>();
  }

  WholeFile& file;
  int width = 0;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::optional<Error> failed;
};

void PngStream::Close::operator()(State* state) const noexcept {
  png_destroy_write_struct(&state->png, &state->info);
  delete state;
}

Result<PngStream> PngStream::begin(WholeFile& file, int width, int height) {
  assert(width > 0 && height > 0);
  std::unique_ptr<State, Close> state(new State(file));
  state->width = width;
  state->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jump_back, ignore_warning);
  if (state->png != nullptr) state->info = png_create_info_struct(state->png);
  if (state->info == nullptr) return Error{Code::file_write, 0, "the PNG encoder cannot be set up"};
  png_set_write_fn(state->png, state.get(), &State::keep_bytes, ignore_flush);
  const bool started =
      start(state->png, state->info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height));
  if (auto begun = state->outcome(started); !begun) return begun.error();
  return PngStream(std::move(state));
}

Result<void> PngStream::write_row(std::span<const std::uint8_t> row) {
  assert(row.size() == 3 * std::size_t(state_->width));
  if (state_->failed) return *state_->failed;
  return state_->outcome(add_row(state_->png, row.data()));
}

Result<void> PngStream::end() {
  if (state_->failed) return *state_->failed;
  return state_->outcome(close(state_->png));
}

}  // namespace cdfr
