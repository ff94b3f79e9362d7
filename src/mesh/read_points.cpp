#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "cdfr/mesh/read.h"
#include "core/mapped_file.h"
#include "mesh/csv_points.h"
#include "mesh/readers.h"
#include "mesh/text.h"

namespace cdfr {
namespace {

// No line of numbers is this long; a stream without line ends must not fill memory.
constexpr std::size_t longest_line = std::size_t{1} << 20;

/// Adds the whole lines of `text` and leaves the last, unfinished one in it.
Result<void> add_lines(std::string& text, CsvPoints& points) {
  std::size_t start = 0;
  for (auto end = text.find('\n'); end != text.npos; end = text.find('\n', start)) {
    if (auto done = points.add_line(std::string_view(text).substr(start, end - start)); !done) return done;
    start = end + 1;
  }
  text.erase(0, start);
  if (text.size() > longest_line) return Error{Code::file_format, 0, "standard input has a line over 1 MiB"};
  return {};
}

Result<std::vector<Vec3>> read_standard_input() {
  CsvPoints points;
  std::string text;
  std::array<char, 1 << 16> block{};
  while (true) {
    const ssize_t count = ::read(STDIN_FILENO, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      return Error{Code::file_open, 0,
                   "cannot read standard input: " + std::generic_category().message(errno)};
    }
    if (count == 0) break;
    text.append(block.data(), static_cast<std::size_t>(count));
    if (auto done = add_lines(text, points); !done) return done.error();
  }
  if (auto done = points.add_line(text); !done) return done.error();
  return std::move(points).take();
}

}  // namespace

Result<std::vector<Vec3>> read_points_bytes(std::span<const std::byte> bytes) {
  if (begins_with(bytes, "\x93NUMPY")) return read_npy(bytes);
  if (!begins_with(bytes, "ply\n") && !begins_with(bytes, "ply\r")) return read_csv(bytes);
  auto mesh = read_ply(bytes);
  if (!mesh) return mesh.error();
  return std::move(mesh->vertices);
}

Result<std::vector<Vec3>> read_points(const std::filesystem::path& path) {
  if (path == "-") return read_standard_input();
  const auto file = MappedFile::open(path);
  if (!file) return file.error();
  return read_points_bytes(file->bytes());
}

}  // namespace cdfr
