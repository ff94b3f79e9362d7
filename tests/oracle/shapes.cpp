#include "oracle/shapes.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "oracle/vectors.h"

namespace cdfr::oracle {
namespace {

double supported(double x) {
  const double size = std::abs(x);
  return size < 0x1p-200 ? 0 : std::copysign(std::min(size, 0x1p200), x);
}

Corners supported(Corners v) {
  for (Vec3& corner : v) corner = {supported(corner.x), supported(corner.y), supported(corner.z)};
  return v;
}

Corners transformed(const Corners& v, double scale, Vec3 offset) {
  return supported({plus(offset, scale, v[0]), plus(offset, scale, v[1]), plus(offset, scale, v[2])});
}

Corners rotated(Random& random, const Corners& v) {
  const std::size_t first = random.below(3);
  return {v[first], v[(first + 1) % 3], v[(first + 2) % 3]};
}

/// Half of the shapes start at the origin, where small differences keep all their bits.
Vec3 place(Random& random) { return random.below(2) == 0 ? Vec3{} : random.direction(); }

Corners friendly(Random& random) { return {random.direction(), random.direction(), random.direction()}; }

Corners needle(Random& random) {
  const Vec3 a = place(random);
  const Vec3 b = plus(a, 1, random.direction());
  return rotated(random, supported({a, b, plus(a, random.power_of_ten(-15, 0), random.direction())}));
}

Corners cap(Random& random) {
  const Vec3 a = place(random);
  const Vec3 u = random.direction();
  const Vec3 on = plus(a, random.unit(), u);
  const double height = random.power_of_ten(-15, 0);
  return rotated(random, supported({a, plus(a, 1, u), plus(on, height, random.direction())}));
}

/// Along an axis, where no rounding limits the aspect ratio: to 1e50.
Corners axis_cap(Random& random) {
  const double height = random.power_of_ten(-50, -10);
  const double x = random.below(4) == 0 ? 0.5 : random.between(-0.5, 1.5);
  Corners v{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{x, height, random.below(2) == 0 ? 0 : -height}};
  for (std::uint64_t turns = random.below(3); turns > 0; --turns) {
    for (Vec3& corner : v) corner = {corner.z, corner.x, corner.y};
  }
  return rotated(random, supported(v));
}

Corners any_shape(Random& random) {
  switch (random.below(4)) {
    case 0:
      return friendly(random);
    case 1:
      return needle(random);
    case 2:
      return cap(random);
    default:
      return axis_cap(random);
  }
}

Corners far_from_origin(Random& random) {
  const Corners v = any_shape(random);
  const double scale = random.power_of_ten(-3, 3);
  return transformed(v, scale, times(1e6, random.direction()));
}

Corners any_size(Random& random) {
  const Corners v = any_shape(random);
  return transformed(v, random.power_of_ten(-60, 60), {});
}

/// Small whole coordinates: right angles, equal sides and exact ties.
Corners lattice(Random& random) {
  const auto coordinate = [&] { return static_cast<double>(random.below(5)) - 2; };
  for (;;) {
    Corners v;
    for (Vec3& corner : v) corner = {coordinate(), coordinate(), coordinate()};
    const Vec3 n = cross(minus(v[1], v[0]), minus(v[2], v[0]));
    if (dot(n, n) > 0) return v;
  }
}

Corners mixed_scales(Random& random) {
  const int reach = random.below(2) == 0 ? 30 : 200;
  const auto coordinate = [&] {
    const double size = random.below(6) == 0 ? 0 : random.magnitude(-reach, reach);
    return random.below(2) == 0 ? size : -size;
  };
  Corners v;
  for (Vec3& corner : v) corner = {coordinate(), coordinate(), coordinate()};
  return v;
}

/// Exactly none, since whole multiples of a short vector do not round.
Corners no_area(Random& random) {
  const auto whole = [&] { return static_cast<double>(random.below(2001)) - 1000; };
  const Vec3 a{whole(), whole(), whole()};
  const Vec3 e{whole(), whole(), whole()};
  const auto multiple = [&] { return static_cast<double>(random.below(7)) - 3; };
  const double scale = std::ldexp(1, static_cast<int>(random.below(200)) - 100);
  const Corners v{a, plus(a, multiple(), e), plus(a, multiple(), e)};
  return rotated(random, {times(scale, v[0]), times(scale, v[1]), times(scale, v[2])});
}

double size_of(const Corners& v) {
  const double size =
      std::max({length(minus(v[1], v[0])), length(minus(v[2], v[1])), length(minus(v[0], v[2]))});
  return size > 0 ? size : std::max(1e-60, length(v[0]));
}

/// A length between 10^low and 10^high of the triangle's size.
double share_of(Random& random, const Corners& v, double low, double high) {
  return size_of(v) * random.power_of_ten(low, high);
}

Vec3 inside(Random& random, const Corners& v) {
  const double s = random.unit();
  const double t = (1 - s) * random.unit();
  return plus(plus(v[0], s, minus(v[1], v[0])), t, minus(v[2], v[0]));
}

Vec3 on_edge(Random& random, const Corners& v) {
  const std::size_t i = random.below(3);
  return plus(v[i], random.below(4) == 0 ? 0.5 : random.unit(), minus(v[(i + 1) % 3], v[i]));
}

Vec3 at_vertex(Random& random, const Corners& v) { return v[random.below(3)]; }

Vec3 normal_of(Random& random, const Corners& v) {
  const Vec3 n = cross(minus(v[1], v[0]), minus(v[2], v[0]));
  const double size = length(n);
  return size > 0 && std::isfinite(size) ? times(1 / size, n) : random.direction();
}

Vec3 around(Random& random, const Corners& v) {
  return plus(inside(random, v), share_of(random, v, -1, 0.5), random.direction());
}

Vec3 near_plane(Random& random, const Corners& v) {
  return plus(inside(random, v), share_of(random, v, -17, 0), normal_of(random, v));
}

Vec3 near_edge(Random& random, const Corners& v) {
  return plus(on_edge(random, v), share_of(random, v, -17, 0), random.direction());
}

Vec3 near_vertex(Random& random, const Corners& v) {
  return plus(at_vertex(random, v), share_of(random, v, -17, 0), random.direction());
}

/// Up to one ulp off in each coordinate.
Vec3 nudged(Random& random, Vec3 p) {
  const auto step = [&](double x) {
    const std::uint64_t way = random.below(3);
    return way == 0 ? x : std::nextafter(x, way == 1 ? 0x1p240 : -0x1p240);
  };
  return {step(p.x), step(p.y), step(p.z)};
}

Vec3 ulp_off(Random& random, const Corners& v) {
  switch (random.below(3)) {
    case 0:
      return nudged(random, at_vertex(random, v));
    case 1:
      return nudged(random, on_edge(random, v));
    default:
      return nudged(random, inside(random, v));
  }
}

/// On the planes that part the face's, edges' and vertices' regions: through an edge or a vertex, along the
/// normal, and through a vertex across an edge.
Vec3 border(Random& random, const Corners& v) {
  const std::size_t i = random.below(3);
  const Vec3 e = minus(v[(i + 1) % 3], v[i]);
  const double size = length(e);
  const Vec3 n = normal_of(random, v);
  const Vec3 across = size > 0 ? times(1 / size, cross(e, n)) : random.direction();
  const Vec3 start = random.below(2) == 0 ? on_edge(random, v) : v[i];
  const Vec3 up = plus(start, random.signed_unit() * share_of(random, v, -3, 1), n);
  const Vec3 p = random.below(2) == 0 ? up : plus(up, share_of(random, v, -3, 1), across);
  return nudged(random, p);
}

Vec3 far_10(Random& random, const Corners& v) { return plus(v[0], 10 * size_of(v), random.direction()); }
Vec3 far_1e3(Random& random, const Corners& v) { return plus(v[0], 1e3 * size_of(v), random.direction()); }
Vec3 far_1e9(Random& random, const Corners& v) { return plus(v[0], 1e9 * size_of(v), random.direction()); }

/// Zeros of both signs and denormal numbers among the coordinates.
Vec3 zeros(Random& random, const Corners& v) {
  Vec3 p = around(random, v);
  for (double* x : {&p.x, &p.y, &p.z}) {
    switch (random.below(6)) {
      case 0:
        *x = 0;
        break;
      case 1:
        *x = -0.0;
        break;
      case 2:
        *x = std::copysign(5e-324 * static_cast<double>(1 + random.below(1000)), *x);
        break;
      case 3:
        *x = std::copysign(0x1p-1030, *x);
        break;
      default:
        break;
    }
  }
  return p;
}

/// Few bits: with lattice triangles, exactly on planes, edges and borders.
Vec3 coarse(Random& random, const Corners& v) {
  const Vec3 p = around(random, v);
  const int exponent = std::ilogb(size_of(v)) - 2;
  const auto rounded = [&](double x) {
    return std::ldexp(std::nearbyint(std::ldexp(x, -exponent)), exponent);
  };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

}  // namespace

std::span<const ShapeFamily> shape_families() noexcept {
  static constexpr ShapeFamily families[] = {
      {"friendly", friendly},
      {"needle", needle},
      {"cap", cap},
      {"axis_cap", axis_cap},
      {"lattice", lattice},
      {"far_from_origin", far_from_origin},
      {"any_size", any_size},
      {"mixed_scales", mixed_scales},
      {"no_area", no_area, true},
  };
  return families;
}

std::span<const QueryFamily> query_families() noexcept {
  static constexpr QueryFamily families[] = {
      {"around", around},   {"near_plane", near_plane},   {"inside", inside},       {"near_edge", near_edge},
      {"on_edge", on_edge}, {"near_vertex", near_vertex}, {"at_vertex", at_vertex}, {"ulp_off", ulp_off},
      {"border", border},   {"far_10", far_10},           {"far_1e3", far_1e3},     {"far_1e9", far_1e9},
      {"zeros", zeros},     {"coarse", coarse},
  };
  return families;
}

}  // namespace cdfr::oracle
