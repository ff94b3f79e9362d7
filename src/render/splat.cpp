/// The picture is drawn in bands of rows, so that its size does not decide how much memory it takes.
#include "cdfr/render/splat.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/vector.h"
#include "core/whole_file.h"
#include "render/band.h"
#include "render/draw.h"
#include "render/png_stream.h"
#include "render/shade.h"
#include "render/spacing.h"
#include "render/view.h"

namespace cdfr {
namespace {

constexpr double greatest_coordinate = 0x1p200;
constexpr int samples_a_band = 1 << 20;
constexpr int least_rows = 8;

// Splats: a little larger than the spacing, as points of a contour are not spread evenly; of a cloud too
// small to have a spacing, spots; and never so large that single points pass for a surface.
constexpr double splat_share = 1.25;
constexpr double spot_pixels = 3, greatest_share_of_side = 0.05;
constexpr std::size_t few_points = 16;

bool usable(Vec3 v) {
  return std::abs(v.x) <= greatest_coordinate && std::abs(v.y) <= greatest_coordinate &&
         std::abs(v.z) <= greatest_coordinate;
}

/// Grows around points one at a time.
struct Bounds {
  Eigen::Vector3d lo = Eigen::Vector3d::Constant(HUGE_VAL), hi = -lo;

  void add(Vec3 v) {
    lo = lo.cwiseMin(to_eigen(v));
    hi = hi.cwiseMax(to_eigen(v));
  }
  Box box() const {
    return lo.x() <= hi.x() ? Box{{lo.x(), lo.y(), lo.z()}, {hi.x(), hi.y(), hi.z()}} : Box{};
  }
};

Error unusable(const char* what, std::size_t number, Vec3 v) {
  const bool finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  return {
      finite ? Code::out_of_range : Code::not_finite, number,
      std::string(what) + " " + std::to_string(number) + (finite ? " is beyond 2^200" : " is not finite")};
}

/// The box of the vertices that triangles use.
Result<Box> box_of(MeshView part) {
  Bounds bounds;
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    for (const std::uint32_t corner : part.triangles[i]) {
      if (corner >= part.vertices.size()) {
        return Error{Code::bad_index, i, "triangle " + std::to_string(i) + " names a vertex beyond the last"};
      }
      const Vec3 v = part.vertices[corner];
      if (!usable(v)) return unusable("vertex", corner, v);
      bounds.add(v);
    }
  }
  return bounds.box();
}

Result<Box> box_of(std::span<const ContourPoint> points) {
  Bounds bounds;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!usable(points[i].position)) return unusable("point", i, points[i].position);
    bounds.add(points[i].position);
  }
  return bounds.box();
}

/// In samples.
double splat_radius(std::span<const ContourPoint> points, const Box& box, const View& view) {
  if (points.size() < few_points) return spot_pixels * samples_per_pixel;
  const double side = std::min(view.width(), view.height()) * double(samples_per_pixel);
  return std::min(splat_share * spacing_on_surface(points, box) * view.scale(),
                  greatest_share_of_side * side);
}

struct Picture {
  std::span<const ContourPoint> points;
  MeshView part;
  const View& view;
  double radius;
};

/// Mean of a pixel's samples.
void set_pixel(const Band& band, const View& view, int column, int row, std::uint8_t* rgb) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int dy = 0; dy < samples_per_pixel; ++dy) {
    for (int dx = 0; dx < samples_per_pixel; ++dx) {
      sum += shade(band, column * samples_per_pixel + dx, row * samples_per_pixel + dy,
                   static_cast<float>(view.depth()));
    }
  }
  const Eigen::Vector3f mean = sum / (samples_per_pixel * samples_per_pixel);
  for (int k = 0; k < 3; ++k)
    rgb[k] = static_cast<std::uint8_t>(std::clamp(mean[k], 0.0F, 1.0F) * 255 + 0.5F);
}

Result<void> write_band(const Picture& picture, int first_row, int end_row, PngStream& png) {
  const View& view = picture.view;
  const int width = view.width() * samples_per_pixel;
  const int above = first_row * samples_per_pixel - shade_reach;
  Band band(width, above, (end_row - first_row) * samples_per_pixel + 2 * shade_reach);
  draw_part(picture.part, view, band);
  draw_points(picture.points, view, picture.radius, band.points);
  std::vector<std::uint8_t> pixels(3 * static_cast<std::size_t>(view.width()));
  for (int row = first_row; row < end_row; ++row) {
    for (int column = 0; column < view.width(); ++column) {
      set_pixel(band, view, column, row, &pixels[3 * static_cast<std::size_t>(column)]);
    }
    if (auto written = png.write_row(pixels); !written) return written;
  }
  return {};
}

Result<void> write_picture(const Picture& picture, WholeFile& file) {
  const View& view = picture.view;
  auto png = PngStream::begin(file, view.width(), view.height());
  if (!png) return png.error();
  const int a_row = view.width() * samples_per_pixel * samples_per_pixel;
  const int rows = std::max(samples_a_band / a_row, least_rows);
  for (int row = 0; row < view.height(); row += rows) {
    auto written = write_band(picture, row, std::min(row + rows, view.height()), *png);
    if (!written) return written;
  }
  return png->end();
}

}  // namespace

Result<void> splat_png(std::span<const ContourPoint> points, MeshView part, const std::filesystem::path& path,
                       const SplatOptions& options) {
  const auto part_box = box_of(part);
  if (!part_box) return part_box.error();
  const auto points_box = box_of(points);
  if (!points_box) return points_box.error();
  const auto view = View::fit(options, part.triangles.empty() ? *points_box : *part_box);
  if (!view) return view.error();
  auto file = WholeFile::create(path);
  if (!file) return file.error();
  const Picture picture{points, part, *view, splat_radius(points, *points_box, *view)};
  if (auto written = write_picture(picture, *file); !written) return written;
  return file->finish();
}

}  // namespace cdfr
