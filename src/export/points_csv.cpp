#include <cstdint>
#include <string>

#include "export/number_text.h"
#include "export/point_formats.h"

namespace cdfr {
namespace {

class CsvPoints final : public PointFormat {
 public:
  Result<void> begin(WholeFile& file) override { return file.write("x,y,z,nx,ny,nz,triangle,error\n"); }

  Result<void> append(WholeFile& file, std::span<const ContourPoint> points) override {
    for (const ContourPoint& point : points) {
      line_.clear();
      for (const Vec3 v : {point.position, point.normal}) {
        for (const double coordinate : {v.x, v.y, v.z}) {
          append_number(line_, coordinate);
          line_ += ',';
        }
      }
      append_number(line_, point.triangle);
      line_ += ',';
      append_number(line_, point.error);
      line_ += '\n';
      if (auto written = file.write(line_); !written) return written;
    }
    return {};
  }

  Result<void> end(WholeFile&, std::uint64_t) override { return {}; }

 private:
  std::string line_;
};

}  // namespace

std::unique_ptr<PointFormat> csv_points() { return std::make_unique<CsvPoints>(); }

}  // namespace cdfr
