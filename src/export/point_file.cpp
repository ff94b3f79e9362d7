#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cdfr/export/write.h"
#include "core/whole_file.h"
#include "export/extension.h"
#include "export/point_formats.h"

namespace cdfr {
namespace {

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// A PointFile in any format. The first error is kept and returned by every later call, so that no part of an
/// extraction can pass for the whole.
class FormattedPointFile final : public PointFile {
 public:
  FormattedPointFile(WholeFile file, std::unique_ptr<PointFormat> format)
      : file_(std::move(file)), format_(std::move(format)) {}

  Result<void> begin() { return keep(format_->begin(file_)); }

  Result<void> write(std::span<const ContourPoint> points) override {
    if (failed_) return *failed_;
    if (auto checked = keep(check(points)); !checked) return checked;
    count_ += points.size();
    return keep(format_->append(file_, points));
  }

  Result<void> finish() override {
    if (failed_) return *failed_;
    if (auto ended = keep(format_->end(file_, count_)); !ended) return ended;
    return keep(file_.finish());
  }

 private:
  Result<void> keep(Result<void> result) {
    if (!result) failed_ = result.error();
    return result;
  }

  Result<void> check(std::span<const ContourPoint> points) const {
    if (points.size() > format_->limit() - count_) {
      return Error{Code::file_write, format_->limit(),
                   "this format holds at most " + std::to_string(format_->limit()) +
                       " points (4 GiB); PLY and CSV have no limit"};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ContourPoint& point = points[i];
      if (finite(point.position) && finite(point.normal) && !std::isnan(point.error)) continue;
      return Error{Code::not_finite, count_ + i, "point " + std::to_string(count_ + i) + " is not finite"};
    }
    return {};
  }

  WholeFile file_;
  std::unique_ptr<PointFormat> format_;
  std::uint64_t count_ = 0;
  std::optional<Error> failed_;
};

std::unique_ptr<PointFormat> format_for(const std::string& extension, double metres_per_unit) {
  if (extension == ".ply") return ply_points();
  if (extension == ".csv") return csv_points();
  if (extension == ".glb") return glb_points(metres_per_unit);
  return nullptr;
}

}  // namespace

Result<std::unique_ptr<PointFile>> create_point_file(const std::filesystem::path& path,
                                                     double metres_per_unit) {
  if (!std::isfinite(metres_per_unit) || metres_per_unit <= 0) {
    return Error{Code::bad_option, 0, "metres a unit must be finite and positive"};
  }
  const std::string extension = format_of(path);
  auto format = format_for(extension, metres_per_unit);
  if (!format) {
    return Error{Code::bad_option, 0, "points are written as .ply, .csv or .glb, not as '" + extension + "'"};
  }
  auto file = WholeFile::create(path);
  if (!file) return file.error();
  auto points = std::make_unique<FormattedPointFile>(std::move(*file), std::move(format));
  if (auto begun = points->begin(); !begun) return begun.error();
  return std::unique_ptr<PointFile>(std::move(points));
}

}  // namespace cdfr
