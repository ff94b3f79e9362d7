#include <array>

#include "soak/changes.h"
#include "soak/families.h"

namespace cdfr::soak {
namespace {

/// A multiple of 2^-10, so that midpoints and small sums are exact.
double coarse(test::Random& random) { return static_cast<double>(random.below(2048)) * 0x1p-10 - 1; }
Vec3 coarse_point(test::Random& random) { return {coarse(random), coarse(random), coarse(random)}; }

Mesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Mesh mesh;
  mesh.vertices = {a, b, c, d};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return outward(std::move(mesh));
}

/// The prism over the triangle ridge-low-high; the ridge runs from a to b, and both slopes are cut along the
/// diagonal from a, so that they do not cross however close they are.
Mesh prism(const std::array<Vec3, 2>& ridge, const std::array<Vec3, 2>& low,
           const std::array<Vec3, 2>& high) {
  Mesh mesh;
  mesh.vertices = {ridge[0], ridge[1], low[0], low[1], high[0], high[1]};
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}, {2, 4, 5}, {2, 5, 3}, {0, 4, 2}, {1, 3, 5}};
  return outward(std::move(mesh));
}

Vec3 between(const Vec3& a, const Vec3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

}  // namespace

/// Dihedral angles from 1e-1 to 1e-16, and on to 1e-40: along the axes, then in any direction, where the
/// opening is a few ulps of the coordinates in the sharpest.
Shape make_wedge(std::uint64_t round, test::Random& random) {
  const std::uint64_t n = round % 4 == 2 ? strided(round / 4, 17, 40) : strided(round, 1, 16);
  const double angle = tenth(n);
  const std::string text = "angle " + tenth_text(n);
  if (round % 2 == 0) {
    Shape shape{text + " along the axes",
                prism({Vec3{0, 0, 0}, Vec3{0, 1, 0}}, {Vec3{1, 0, 0}, Vec3{1, 1, 0}},
                      {Vec3{1, 0, angle}, Vec3{1, 1, angle}})};
    return random.below(2) == 0 ? shape : accompanied(std::move(shape), random);
  }
  const Vec3 a = random.in({{-1, -1, -1}, {1, 1, 1}}), b = random.in({{-1, -1, -1}, {1, 1, 1}});
  const Vec3 c = random.in({{-1, -1, -1}, {1, 1, 1}}), d = between(c, b, random.between(0.2, 0.8));
  const Vec3 up = random.in({{-1, -1, -1}, {1, 1, 1}});
  const auto raised = [&](const Vec3& v) {
    return Vec3{v.x + angle * up.x, v.y + angle * up.y, v.z + angle * up.z};
  };
  return {text, prism({a, b}, {c, d}, {raised(c), raised(d)})};
}

/// A body whose edges are split on one side only: the gap is closed by a triangle of height h, often 0.
Shape make_cap(std::uint64_t round, test::Random& random) {
  Mesh mesh = round % 2 == 0 ? tetrahedron(coarse_point(random), coarse_point(random), coarse_point(random),
                                           coarse_point(random))
                             : make_blocks(round, random).mesh;
  const std::uint64_t n = strided(round / 2, 1, 16);
  const double height = round % 4 < 2 ? 0 : tenth(n);
  const std::uint64_t count = 1 + random.below(1 + mesh.triangles.size());
  Shape shape{std::to_string(count) + (height == 0 ? " of height 0" : " of height " + tenth_text(n)), {}};
  shape.mesh = capped(std::move(mesh), count, height, random);
  return shape;
}

/// Pyramids over polygons as small as 1e-12 of their height, single or on both sides of the polygon.
Shape make_needle(std::uint64_t round, test::Random& random) {
  const std::uint64_t n = strided(round, 1, 12);
  const std::uint32_t corners = 3 + static_cast<std::uint32_t>(random.below(round % 3 == 2 ? 40 : 4));
  const bool two_sided = round % 2 == 1;
  Mesh mesh;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const OnCircle at = on_circle((i + random.between(0, 0.5)) / corners);
    add_vertex(mesh, {tenth(n) * at.x, tenth(n) * at.y, 0});
  }
  const double lean = round % 3 == 0 ? 0 : 1;
  const std::uint32_t tip = add_vertex(mesh, {lean * random.between(-1, 1), lean * random.between(-1, 1), 1});
  const std::uint32_t other = two_sided ? add_vertex(mesh, {0, 0, -random.between(0, 1)}) : 0;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t j = (i + 1) % corners;
    mesh.triangles.push_back({i, j, tip});
    if (two_sided) mesh.triangles.push_back({j, i, other});
    if (!two_sided && i > 0 && j > 0) mesh.triangles.push_back({0, j, i});
  }
  return {std::string(two_sided ? "two-sided " : "") + "width " + tenth_text(n) + ", " +
              std::to_string(corners) + " corners",
          std::move(mesh)};
}

/// Tetrahedra as flat as 1e-50 of their width, along the axes and in any direction.
Shape make_flat(std::uint64_t round, test::Random& random) {
  const std::uint64_t n = round % 2 == 0 ? strided(round / 2, 2, 50) : strided(round / 2, 2, 15);
  const double height = tenth(n);
  if (round % 2 == 0) {
    Shape shape{"height " + tenth_text(n),
                tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                            {random.between(-0.5, 1), random.between(-0.5, 1), height})};
    return random.below(2) == 0 ? shape : accompanied(std::move(shape), random);
  }
  const Vec3 a = random.in({{-1, -1, -1}, {1, 1, 1}}), b = random.in({{-1, -1, -1}, {1, 1, 1}});
  const Vec3 c = random.in({{-1, -1, -1}, {1, 1, 1}});
  Vec3 d = between(between(a, b, random.between(-0.5, 1)), c, random.between(-0.5, 1));
  d.z += height;
  return {"height " + tenth_text(n) + " in any direction", tetrahedron(a, b, c, d)};
}

}  // namespace cdfr::soak
