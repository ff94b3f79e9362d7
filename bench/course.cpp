#include "course.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
  constexpr std::uint32_t side = 256;
  return {box.lo, 1.0 / (side - 1) * (box.hi - box.lo), {side, side, side}};
}

/// `count` slabs of `planes` planes each, evenly over the grid.
std::vector<SampleGrid> slabs(const SampleGrid& grid, std::uint32_t count, std::uint32_t planes) {
  std::vector<SampleGrid> spread;
  for (std::uint32_t s = 0; s < count; ++s) {
    spread.push_back(slab(grid, (2 * s + 1) * grid.size[2] / (2 * count) - planes / 2, planes));
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

Result<Course> make_course(const Model& model, const Effort& effort) {
  Result<Mesh> mesh = load_as_float(model);
  if (!mesh) return mesh.error();
  const Box box = box_of(*mesh), around = scaled(box, 1.1);
  Course course;
  course.mesh = std::move(*mesh);
  course.diagonal = length(box.hi - box.lo);
  Random random;
  course.batch = points_in(around, effort.batch_points, random);
  course.random.assign(course.batch.begin(), course.batch.begin() + static_cast<long>(effort.points));
  course.near = points_near(course.mesh, course.diagonal / 100, effort.points, random);
  course.far = points_in(scaled(box, 10), effort.points, random);
  const SampleGrid grid = grid_over(around);
  course.grid = slabs(grid, effort.slabs, effort.slab_planes);
  course.grid_peers = slabs(grid, 4, 1);
  return {std::move(course)};
}

}  // namespace cdfr::bench
