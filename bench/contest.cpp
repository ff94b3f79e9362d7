#include "contest.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cdfr/field/field.h"
#include "cdfr/mesh/weld.h"
#include "random.h"

namespace cdfr::bench {
namespace {

Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
double length(Vec3 a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

/// Points that float holds exactly: every system gets the same ones, to the last bit.
Vec3 as_float(Vec3 p) { return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}; }

Box box_of(const Mesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Vec3& v : mesh.vertices) {
    box.lo = {std::min(box.lo.x, v.x), std::min(box.lo.y, v.y), std::min(box.lo.z, v.z)};
    box.hi = {std::max(box.hi.x, v.x), std::max(box.hi.y, v.y), std::max(box.hi.z, v.z)};
  }
  return box;
}

Box scaled(const Box& box, double factor) {
  const Vec3 grow = (factor - 1) / 2 * (box.hi - box.lo);
  return {box.lo - grow, box.hi + grow};
}

std::vector<Vec3> points_in(const Box& box, std::size_t count, Random& random) {
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = as_float(random.in(box));
  return points;
}

/// Areas of the triangles, each added to those before it.
std::vector<double> summed_areas(const Mesh& mesh) {
  std::vector<double> sums;
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]], b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    sum += length({a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x});
    sums.push_back(sum);
  }
  return sums;
}

std::vector<Vec3> points_near(const Mesh& mesh, double reach, std::size_t count, Random& random) {
  const std::vector<double> sums = summed_areas(mesh);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) {
    const auto at = std::upper_bound(sums.begin(), sums.end() - 1, random.unit() * sums.back());
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(at - sums.begin())];
    const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    double u = random.unit(), v = random.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    p = as_float(a + u * (b - a) + v * (c - a) + reach * random.unit() * random.direction());
  }
  return points;
}

SampleGrid grid_over(const Box& box) {
  SampleGrid grid;
  grid.origin = box.lo;
  grid.spacing = 1 / static_cast<double>(grid.side - 1) * (box.hi - box.lo);
  return grid;
}

/// `slabs` slabs of `planes` planes each, evenly over the grid.
std::vector<Planes> spread_slabs(const SampleGrid& grid, std::size_t slabs, std::size_t planes) {
  std::vector<Planes> spread;
  for (std::size_t s = 0; s < slabs; ++s) {
    spread.push_back({(2 * s + 1) * grid.side / (2 * slabs) - planes / 2, planes});
  }
  return spread;
}

Result<Mesh> load_as_float(const Model& model) {
  Result<Mesh> mesh = load_model(model);
  if (!mesh) return mesh;
  for (Vec3& v : mesh->vertices) v = as_float(v);
  Result<Welded> welded = weld(*mesh, 0);
  if (!welded) return welded.error();
  return std::move(welded->mesh);
}

void add_evenly(const std::vector<Vec3>& points, std::size_t wanted, std::vector<Vec3>& chosen) {
  const std::size_t step = std::max<std::size_t>(1, points.size() / wanted);
  for (std::size_t i = 0; i < points.size(); i += step) chosen.push_back(points[i]);
}

Result<Truth> find_truth(const Contest& contest, const Effort& effort) {
  const auto affordable = effort.checked_triangles / static_cast<double>(contest.mesh.triangles.size());
  const auto wanted = static_cast<std::size_t>(std::max(16.0, affordable));
  Truth truth;
  for (const auto* points : {&contest.random, &contest.near, &contest.far}) {
    add_evenly(*points, wanted, truth.points);
  }
  add_evenly(contest.grid.planes(contest.planes_peers.front().first, 1), wanted, truth.points);
  const Result<BruteForce> brute = BruteForce::over(contest.mesh.view());
  if (!brute) return brute.error();
  for (const Vec3& p : truth.points) truth.distances.push_back(brute->closest(p).distance);
  return truth;
}

}  // namespace

Effort quick_effort() {
  return {.points = 20'000,
          .batch_points = 200'000,
          .slabs = 4,
          .slab_planes = 4,
          .rounds = 3,
          .build_rounds = 1,
          .checked_triangles = 2e7};
}

Result<Contest> make_contest(const Model& model, const Effort& effort) {
  Result<Mesh> mesh = load_as_float(model);
  if (!mesh) return mesh.error();
  const Box box = box_of(*mesh), around = scaled(box, 1.1);
  Contest contest;
  contest.mesh = std::move(*mesh);
  contest.diagonal = length(box.hi - box.lo);
  Random random;
  contest.batch = points_in(around, effort.batch_points, random);
  contest.random.assign(contest.batch.begin(), contest.batch.begin() + static_cast<long>(effort.points));
  contest.near = points_near(contest.mesh, contest.diagonal / 100, effort.points, random);
  contest.far = points_in(scaled(box, 10), effort.points, random);
  contest.grid = grid_over(around);
  contest.planes_cdfr = spread_slabs(contest.grid, effort.slabs, effort.slab_planes);
  contest.planes_peers = spread_slabs(contest.grid, 4, 1);
  Result<Truth> truth = find_truth(contest, effort);
  if (!truth) return truth.error();
  contest.truth = std::move(*truth);
  for (const SystemKind& kind : system_kinds()) {
    auto built = kind.build(contest.mesh, 1);
    if (!built) return built.error();
    contest.systems.push_back(std::move(*built));
  }
  return {std::move(contest)};
}

}  // namespace cdfr::bench
