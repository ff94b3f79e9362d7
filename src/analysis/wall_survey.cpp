#include "analysis/wall_survey.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "analysis/first_hit.h"
#include "analysis/largest_ball.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "field/batch_order.h"
#include "geometry/box_distance.h"

namespace cdfr {
namespace {

/// Points that a task takes: enough for their closest points to overlap.
constexpr std::size_t chunk = 1024;
/// More points are taken in rounds of so many, whose order and answers take 200 MB.
constexpr std::size_t round_points = std::size_t{1} << 21;

bool in_range(double value, double least, double below) noexcept { return value >= least && value < below; }

const char* fault_of(const ThicknessOptions& o) noexcept {
  if (!std::isfinite(o.facet)) return "the facet tolerance must be finite";
  if (!(o.sharp > 0 && o.sharp < 180)) return "sharp must be above 0 and below 180 degrees";
  if (!(o.error >= 0 && std::isfinite(o.error))) return "error must be 0 or more and finite";
  if (!in_range(o.cone, 0, 90)) return "the cone must be 0 or more and below 90 degrees";
  if (o.rays < 1 || o.rays > 10000) return "rays must be 1 to 10000";
  if (!(o.largest >= 0 && std::isfinite(o.largest))) return "largest must be 0 or more and finite";
  if (!(o.thinner_than >= 0 && std::isfinite(o.thinner_than)))
    return "the thickness to be thinner than must be 0 or more and finite";
  if (o.at == SampleAt::spacing && !(o.spacing > 0 && std::isfinite(o.spacing)))
    return "spacing must be above 0 and finite";
  if (o.bins < 1 || o.bins > 100000) return "bins must be 1 to 100000";
  if (o.places < 0) return "places must be 0 or more";
  return nullptr;
}

}  // namespace

Result<void> check_thickness(const FieldData& field, const ThicknessOptions& options) {
  if (const char* fault = fault_of(options)) return Error{Code::bad_option, 0, fault};
  if (field.sign == Sign::none)
    return Error{Code::not_closed, 0, "an unsigned field has no inside: no wall has a thickness"};
  return {};
}

WallSurvey::WallSurvey(const FieldData& field, const ThicknessOptions& options) noexcept
    : field_(field), options_(options) {
  const Box& box = field.bounds();
  largest_ = options.largest > 0 ? options.largest : diagonal_above(box);
  rounding_ = ball_rounding(field, largest_ / 2);
  error_ = options.error > 0 ? options.error : std::max(longest_side(box) * 0x1p-30, 8 * rounding_);
}

Result<void> WallSurvey::check() const {
  if (error_ >= 4 * rounding_) return {};
  return Error{Code::bad_option, 0, "error must be at least 128 ulp of the largest coordinate"};
}

double WallSurvey::steps(std::size_t points) noexcept {
  return std::ceil(static_cast<double>(points) / chunk);
}

std::uint64_t WallSurvey::measure(std::span<const WallPoint> points, std::span<MeasuredWall> walls,
                                  Progress& progress) const {
  std::uint64_t queries = 0;
  for (std::size_t start = 0; start < points.size(); start += round_points) {
    const auto round = points.subspan(start, std::min(round_points, points.size() - start));
    std::vector<Vec3> positions;
    positions.reserve(round.size());
    for (const WallPoint& point : round) positions.push_back(point.position);
    const auto order = along_curve(field_, Points(std::span<const Vec3>(positions)), 0, round.size());
    std::vector<std::uint64_t> asked((round.size() + chunk - 1) / chunk);
    for_chunks(round.size(), chunk, [&](std::size_t first, std::size_t end) {
      if (!progress.poll()) return;
      std::vector<WallPoint> some;
      for (std::size_t i = first; i < end; ++i) some.push_back(round[order[i]]);
      std::vector<MeasuredWall> found(some.size());
      asked[first / chunk] = measure_some(some, found, progress);
      for (std::size_t i = first; i < end; ++i) walls[start + order[i]] = found[i - first];
      progress.step();
    });
    queries = std::accumulate(asked.begin(), asked.end(), queries);
    if (progress.cancelled()) break;
  }
  return queries;
}

std::uint64_t WallSurvey::measure_some(std::span<const WallPoint> points, std::span<MeasuredWall> walls,
                                       Progress& progress) const {
  const FloatingEnvironment environment;
  if (options_.method == ThicknessMethod::sphere) {
    const BallOptions ball{options_.clearance, error_ / 2, largest_ / 2, rounding_};
    return largest_balls(field_, points, ball, walls, progress);
  }
  const RayOptions ray{options_.rays, options_.cone, largest_, rounding_};
  for (std::size_t i = 0; i < points.size() && progress.poll(); ++i)
    walls[i] = shortest_ray(field_, points[i], ray);
  return points.size() * static_cast<std::uint64_t>(options_.rays);
}

}  // namespace cdfr
