#include "contest.h"

#include <algorithm>
#include <utility>

#include "cdfr/field/field.h"

namespace cdfr::bench {
namespace {

void add_evenly(const std::vector<Vec3>& points, std::size_t wanted, std::vector<Vec3>& chosen) {
  const std::size_t step = std::max<std::size_t>(1, points.size() / wanted);
  for (std::size_t i = 0; i < points.size(); i += step) chosen.push_back(points[i]);
}

Result<Truth> find_truth(const Course& course, const Effort& effort) {
  const auto affordable = effort.checked_triangles / static_cast<double>(course.mesh.triangles.size());
  const auto wanted = static_cast<std::size_t>(std::max(16.0, affordable));
  Truth truth;
  for (const auto* points : {&course.random, &course.near, &course.far}) {
    add_evenly(*points, wanted, truth.points);
  }
  add_evenly(points_of(course.grid_peers.front(), 0, 1), wanted, truth.points);
  const Result<BruteForce> brute = BruteForce::over(course.mesh.view());
  if (!brute) return brute.error();
  for (const Vec3& p : truth.points) truth.distances.push_back(brute->closest(p).distance);
  return truth;
}

}  // namespace

Result<Contest> make_contest(const Model& model, const Effort& effort) {
  Result<Course> course = make_course(model, effort);
  if (!course) return course.error();
  Contest contest{std::move(*course), {}, {}};
  Result<Truth> truth = find_truth(contest.course, effort);
  if (!truth) return truth.error();
  contest.truth = std::move(*truth);
  for (const SystemKind& kind : system_kinds()) {
    auto built = kind.build(contest.course.mesh, 1);
    if (!built) return built.error();
    contest.systems.push_back(std::move(*built));
  }
  return {std::move(contest)};
}

}  // namespace cdfr::bench
