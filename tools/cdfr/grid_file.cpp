#include "grid_file.h"

#include <algorithm>
#include <string>

#include "binary.h"
#include "byte_sink.h"
#include "number_text.h"
#include "output_target.h"

namespace cdfr::command {
namespace {

/// Numbers turned into bytes at a time.
constexpr std::size_t block_numbers = 65536;

std::string shape_text(const Grid& grid) {
  const auto [x, y, z] = grid.size;
  return "(" + std::to_string(z) + ", " + std::to_string(y) + ", " + std::to_string(x) + ")";
}

std::string exact_text(const Vec3& v) {
  std::string text;
  append_exact(text, v.x);
  append_exact(text += ' ', v.y);
  append_exact(text += ' ', v.z);
  return text;
}

/// VTK's file formats, "ImageData" with appended raw data: an underscore, the number of bytes, the bytes.
std::string vti_header(const Grid& grid) {
  std::string extent;
  for (const std::uint32_t size : grid.size)
    extent += (extent.empty() ? "0 " : " 0 ") + std::to_string(size - 1);
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<ImageData WholeExtent=\"" +
      extent + "\" Origin=\"" + exact_text(grid.origin) + "\" Spacing=\"" + exact_text(grid.spacing) +
      "\">\n<Piece Extent=\"" + extent +
      "\">\n<PointData Scalars=\"distance\">\n"
      "<DataArray type=\"Float64\" Name=\"distance\" format=\"appended\" offset=\"0\"/>\n"
      "</PointData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_";
  append_bytes(text, std::uint64_t{grid.count() * sizeof(double)});
  return text;
}

}  // namespace

GridFile::GridFile(const Grid& grid, const std::filesystem::path& path)
    : is_image_(extension_of(path) == ".vti"), sink_(whole_file(path)) {
  sink_->write(is_image_ ? vti_header(grid) : npy_header(shape_text(grid)));
}

void GridFile::write(std::span<const double> distances) {
  std::string bytes;
  for (std::size_t first = 0; first < distances.size(); first += block_numbers) {
    bytes.clear();
    for (const double d : distances.subspan(first, std::min(block_numbers, distances.size() - first))) {
      append_bytes(bytes, d);
    }
    sink_->write(bytes);
  }
}

void GridFile::finish() {
  if (is_image_) sink_->write("\n</AppendedData>\n</VTKFile>\n");
  sink_->finish();
}

}  // namespace cdfr::command
