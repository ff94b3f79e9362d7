#include "soak/changes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "soak/welded.h"
#include "support/meshes.h"

namespace cdfr::soak {
namespace {

Box box_of(const Mesh& mesh) {
  const double inf = std::numeric_limits<double>::infinity();
  Box box{{inf, inf, inf}, {-inf, -inf, -inf}};
  for (const Vec3& v : mesh.vertices) {
    box.lo = {std::min(box.lo.x, v.x), std::min(box.lo.y, v.y), std::min(box.lo.z, v.z)};
    box.hi = {std::max(box.hi.x, v.x), std::max(box.hi.y, v.y), std::max(box.hi.z, v.z)};
  }
  return box;
}

double size_of(const Mesh& mesh) {
  const Box box = box_of(mesh);
  return std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
}

void move(Shape& shape, test::Random& random) {
  const std::uint64_t n = 1 + random.below(10);
  const double distance = size_of(shape.mesh) / tenth(n == 10 ? 6 : n);
  const Vec3 by = random.in({{-distance, -distance, -distance}, {distance, distance, distance}});
  for (Vec3& v : shape.mesh.vertices) v = {v.x + by.x, v.y + by.y, v.z + by.z};
  shape.text += ", moved by 1e" + std::to_string(n == 10 ? 6 : n) + " sizes";
}

void scale(Shape& shape, test::Random& random) {
  const std::array<double, 6> factors{1e-9, 1e9, 0x1p-140, 0x1p140, 1e-3, 1e6};
  const std::array<const char*, 6> texts{"1e-9", "1e9", "2^-140", "2^140", "1e-3", "1e6"};
  const std::size_t i = random.below(factors.size());
  for (Vec3& v : shape.mesh.vertices) v = {v.x * factors[i], v.y * factors[i], v.z * factors[i]};
  shape.text += std::string(", times ") + texts[i];
}

/// By a random unit quaternion.
void rotate(Shape& shape, test::Random& random) {
  const double a = random.between(-1, 1), b = random.between(-1, 1), c = random.between(-1, 1);
  const double d = random.between(-1, 1), s = 2 / (a * a + b * b + c * c + d * d);
  const std::array<Vec3, 3> rows{{{1 - s * (c * c + d * d), s * (b * c - a * d), s * (b * d + a * c)},
                                  {s * (b * c + a * d), 1 - s * (b * b + d * d), s * (c * d - a * b)},
                                  {s * (b * d - a * c), s * (c * d + a * b), 1 - s * (b * b + c * c)}}};
  const auto dot = [](const Vec3& u, const Vec3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; };
  for (Vec3& v : shape.mesh.vertices) v = {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
  shape.text += ", rotated";
}

void jitter(Shape& shape, test::Random& random) {
  const std::uint64_t n = 3 + random.below(13);
  const double by = tenth(n) * size_of(shape.mesh);
  shape.mesh = welded(shape.mesh);  // what is one place stays one
  for (Vec3& v : shape.mesh.vertices) {
    const Vec3 d = random.in({{-by, -by, -by}, {by, by, by}});
    v = {v.x + d.x, v.y + d.y, v.z + d.z};
  }
  shape.text += ", jittered by " + tenth_text(n);
}

/// Longer along one axis and sheared: slivers everywhere.
void stretch(Shape& shape, test::Random& random) {
  const std::uint64_t n = 1 + random.below(6);
  const double factor = 1 / tenth(n), shear = random.between(-1, 1);
  const std::uint64_t axis = random.below(3);
  for (Vec3& v : shape.mesh.vertices) {
    if (axis == 0) v.x = factor * v.x + shear * v.y;
    if (axis == 1) v.y = factor * v.y + shear * v.z;
    if (axis == 2) v.z = factor * v.z + shear * v.x;
  }
  shape.text += ", stretched by 1e" + std::to_string(n);
}

/// To multiples of 2^-40 of the largest coordinate, so that midpoints are exact.
void coarsen(Mesh& mesh) {
  int exponent = 0;
  const Box box = box_of(mesh);
  std::frexp(std::max({std::fabs(box.lo.x), std::fabs(box.lo.y), std::fabs(box.lo.z), std::fabs(box.hi.x),
                       std::fabs(box.hi.y), std::fabs(box.hi.z)}),
             &exponent);
  const double unit = std::ldexp(1.0, exponent - 40);
  const auto rounded = [&](double x) { return std::nearbyint(x / unit) * unit; };
  for (Vec3& v : mesh.vertices) v = {rounded(v.x), rounded(v.y), rounded(v.z)};
}

void cap(Shape& shape, test::Random& random) {
  const std::uint64_t n = random.below(17), count = 1 + random.below(shape.mesh.triangles.size());
  coarsen(shape.mesh);
  shape.mesh = capped(std::move(shape.mesh), count, n == 0 ? 0 : tenth(n), random);
  shape.text += ", " + std::to_string(count) + " caps of height " + (n == 0 ? "0" : tenth_text(n));
}

/// A cube apart from the mesh, so that much of the space around the mesh is inside the box of them both.
void accompany(Shape& shape, test::Random&) {
  const Box box = box_of(shape.mesh);
  const double size = size_of(shape.mesh);
  const Vec3 lo{box.hi.x + size, box.lo.y - size, box.lo.z - size};
  add_mesh(shape.mesh, test::box_mesh({lo, {lo.x + size, lo.y + 3 * size, lo.z + 3 * size}}), false);
  shape.text += ", beside a cube";
}

}  // namespace

Mesh capped(Mesh mesh, std::uint64_t count, double height, test::Random& random) {
  mesh = welded(mesh);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::size_t t = random.below(mesh.triangles.size()), k = random.below(3);
    const Triangle corners = mesh.triangles[t];
    const std::uint32_t a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
    const Vec3 p = mesh.vertices[a], q = mesh.vertices[b];
    const double rise = height * (std::fabs(q.x - p.x) + std::fabs(q.y - p.y) + std::fabs(q.z - p.z));
    const auto raised = [&](double x, double y) {
      return x / 2 + y / 2 + (rise == 0 ? 0 : rise * random.between(-1, 1));
    };
    const Vec3 middle{raised(p.x, q.x), raised(p.y, q.y), raised(p.z, q.z)};
    if (middle == p || middle == q) continue;
    const std::uint32_t m = add_vertex(mesh, middle);
    mesh.triangles[t] = {a, m, c};
    mesh.triangles.push_back({m, b, c});
    mesh.triangles.push_back({a, b, m});
  }
  return mesh;
}

Shape accompanied(Shape shape, test::Random& random) {
  accompany(shape, random);
  return shape;
}

Shape changed(Shape shape, std::uint64_t kind, test::Random& random) {
  static constexpr std::array changes{move, scale, rotate, jitter, stretch, cap, accompany};
  changes[kind % changes.size()](shape, random);
  return shape;
}

Mesh outward(Mesh mesh) {
  const Vec3 o = mesh.vertices.front();
  long double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    const auto from_first = [&](std::size_t k) {
      const Vec3& v = mesh.vertices[t[k]];
      return std::array<long double, 3>{static_cast<long double>(v.x) - o.x,
                                        static_cast<long double>(v.y) - o.y,
                                        static_cast<long double>(v.z) - o.z};
    };
    const auto a = from_first(0), b = from_first(1), c = from_first(2);
    volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
              a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  if (volume < 0) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

}  // namespace cdfr::soak
