#include <cassert>
#include <cstdint>
#include <string>

#include "export/little_endian.h"
#include "export/number_text.h"
#include "export/point_formats.h"

namespace cdfr {
namespace {

constexpr std::string_view before_count = "ply\nformat binary_little_endian 1.0\n";
constexpr std::string_view after_count =
    "property double x\nproperty double y\nproperty double z\n"
    "property double nx\nproperty double ny\nproperty double nz\n"
    "property double error\nproperty uint triangle\nend_header\n";
constexpr std::size_t widest_count = 20;

/// The lines that hold the count, of the same length for every count. What the count leaves over fills a
/// comment, for blanks or zeros around the number itself are read in more than one way.
std::string count_lines(std::uint64_t count) {
  std::string digits;
  append_number(digits, count);
  assert(digits.size() <= widest_count);
  return "comment written by cdfr " + std::string(widest_count - digits.size(), '.') + "\nelement vertex " +
         digits + "\n";
}

class PlyPoints final : public PointFormat {
 public:
  Result<void> begin(WholeFile& file) override {
    if (auto written = file.write(before_count); !written) return written;
    if (auto written = file.write(count_lines(0)); !written) return written;
    return file.write(after_count);
  }

  Result<void> append(WholeFile& file, std::span<const ContourPoint> points) override {
    for (const ContourPoint& point : points) {
      Record<60> record;
      for (const Vec3 v : {point.position, point.normal}) {
        for (const double coordinate : {v.x, v.y, v.z}) record.append(coordinate);
      }
      record.append(point.error);
      record.append(point.triangle);
      if (auto written = file.write(record.bytes()); !written) return written;
    }
    return {};
  }

  Result<void> end(WholeFile& file, std::uint64_t count) override {
    return file.write_at(before_count.size(), count_lines(count));
  }
};

}  // namespace

std::unique_ptr<PointFormat> ply_points() { return std::make_unique<PlyPoints>(); }

}  // namespace cdfr
