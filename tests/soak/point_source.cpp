#include "soak/point_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "soak/welded.h"

namespace cdfr::soak {
namespace {

Vec3 plus(const Vec3& a, double s, const Vec3& d) { return {a.x + s * d.x, a.y + s * d.y, a.z + s * d.z}; }
Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// Zero stays zero.
Vec3 unit(Vec3 v) {
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(largest > 0)) return {};
  v = {v.x / largest, v.y / largest, v.z / largest};
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {v.x / length, v.y / length, v.z / length};
}

Vec3 direction(test::Random& random) { return unit(random.in({{-1, -1, -1}, {1, 1, 1}})); }

double moved_by_ulps(double x, std::int64_t count) {
  const double to =
      count < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for (std::int64_t i = 0; i < std::abs(count); ++i) x = std::nextafter(x, to);
  return x;
}

/// Each coordinate by -2 to 2 ulps, its own or those at `size`: at 0 its own are of no size at all.
Vec3 shaken(const Vec3& p, double size, test::Random& random) {
  const double unit = random.below(2) == 0 ? 0 : std::nextafter(size, HUGE_VAL) - size;
  const auto some = [&](double x) {
    const std::int64_t count = static_cast<std::int64_t>(random.below(5)) - 2;
    return unit == 0 ? moved_by_ulps(x, count) : x + unit * static_cast<double>(count);
  };
  return {some(p.x), some(p.y), some(p.z)};
}

Vec3 middle(const Vec3& a, const Vec3& b) {
  return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
}

}  // namespace

PointSource::PointSource(const Mesh& mesh, const Field& field)
    : mesh_(mesh), field_(field), box_(field.bounds()), first_around_(mesh.vertices.size() + 1, 0) {
  size_ = std::max({box_.hi.x - box_.lo.x, box_.hi.y - box_.lo.y, box_.hi.z - box_.lo.z});
  const DirectedEdges edges = closed_edges(mesh.triangles).value();
  for (const Triangle& t : mesh.triangles) {
    neighbours_.push_back({edges.at(t[1], t[0]), edges.at(t[2], t[1]), edges.at(t[0], t[2])});
    for (const std::uint32_t v : t) ++first_around_[v + 1];
  }
  for (std::size_t v = 1; v < first_around_.size(); ++v) first_around_[v] += first_around_[v - 1];
  around_.resize(3 * mesh.triangles.size());
  std::vector<std::uint64_t> next = first_around_;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) around_[next[v]++] = t;
  }
}

Vec3 PointSource::normal(std::uint32_t triangle) const {
  const Triangle& t = mesh_.triangles[triangle];
  const Vec3 e = unit(minus(mesh_.vertices[t[1]], mesh_.vertices[t[0]]));
  const Vec3 f = unit(minus(mesh_.vertices[t[2]], mesh_.vertices[t[0]]));
  return unit({e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x});
}

PointSource::Site PointSource::on_face(std::uint32_t triangle, test::Random& random) const {
  const Triangle& t = mesh_.triangles[triangle];
  double u = random.between(0, 1), v = random.between(0, 1);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const Vec3 a = mesh_.vertices[t[0]];
  const Vec3 along = plus(a, u, minus(mesh_.vertices[t[1]], a));
  return {plus(along, v, minus(mesh_.vertices[t[2]], a)), normal(triangle)};
}

PointSource::Site PointSource::on_edge(std::uint32_t triangle, test::Random& random) const {
  const Triangle& t = mesh_.triangles[triangle];
  const std::size_t k = random.below(3);
  const Vec3 a = mesh_.vertices[t[k]], b = mesh_.vertices[t[(k + 1) % 3]];
  const Vec3 n = normal(triangle), m = normal(neighbours_[triangle][k]);
  // Straight up from a face at its edge is where the cell of the edge ends and that of the face begins.
  const std::array weights{0.0, 0.5, 1.0, random.between(0, 1), random.between(0, 1)};
  const double w = weights[random.below(weights.size())];
  const Vec3 away = unit({w * n.x + (1 - w) * m.x, w * n.y + (1 - w) * m.y, w * n.z + (1 - w) * m.z});
  if (random.below(4) == 0) return {middle(a, b), away};
  return {plus(a, random.between(0, 1), minus(b, a)), away};
}

PointSource::Site PointSource::on_vertex(std::uint32_t triangle, test::Random& random) const {
  const std::uint32_t v = mesh_.triangles[triangle][random.below(3)];
  const std::uint64_t first = first_around_[v], count = first_around_[v + 1] - first;
  Vec3 sum;
  // Some of the normals are enough, and at a vertex of valence 1000 all would be slow.
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(count, 6); ++i) {
    const std::uint64_t picked = count <= 6 ? i : random.below(count);
    sum = plus(sum, random.between(0, 1), normal(around_[first + picked]));
  }
  return {mesh_.vertices[v], unit(sum)};
}

PointSource::Site PointSource::anywhere(test::Random& random) const {
  const auto triangle = static_cast<std::uint32_t>(random.below(mesh_.triangles.size()));
  switch (random.below(3)) {
    case 0:
      return on_face(triangle, random);
    case 1:
      return on_edge(triangle, random);
    default:
      return on_vertex(triangle, random);
  }
}

/// From 2^-54 to 2^-3 of the size, any octave as likely as another; a third of them towards the inside.
double PointSource::distance(test::Random& random) const {
  const double octave = std::ldexp(random.between(1, 2), -4 - static_cast<int>(random.below(51)));
  const double sign = random.below(3) == 0 ? -1 : 1;
  return sign * size_ * octave;
}

Vec3 PointSource::some_vertex(test::Random& random) const {
  return mesh_.vertices[random.below(mesh_.vertices.size())];
}

/// In a triangle's plane or on an edge's line, but beyond its ends: a product that decides is all rounding.
Vec3 PointSource::in_common_plane(test::Random& random) const {
  const Triangle& t = mesh_.triangles[random.below(mesh_.triangles.size())];
  const Vec3 a = mesh_.vertices[t[0]];
  const double u = random.between(-2, 3), v = random.below(2) == 0 ? 0 : random.between(-2, 3);
  return plus(plus(a, u, minus(mesh_.vertices[t[1]], a)), v, minus(mesh_.vertices[t[2]], a));
}

/// Coordinates of different vertices, or two of one vertex: rays along the axes meet corners and edges.
Vec3 PointSource::with_borrowed_coordinates(test::Random& random) const {
  Vec3 p = some_vertex(random);
  const Vec3 q = random.below(2) == 0 ? some_vertex(random) : random.in(test::scaled(box_, 1.5));
  switch (random.below(3)) {
    case 0:
      p.x = q.x;
      break;
    case 1:
      p.y = q.y;
      break;
    default:
      p.z = q.z;
  }
  if (random.below(2) == 0) p.z = some_vertex(random).z;
  return p;
}

/// Either half-way between two features, or as far up a normal as its foot remains the closest point.
Vec3 PointSource::on_medial_axis(test::Random& random) const {
  const Site site = anywhere(random);
  if (random.below(3) != 0) return middle(site.at, anywhere(random).at);
  const double sign = random.below(2) == 0 ? -1 : 1;
  double near = 0, far = size_;
  for (int i = 0; i < 24; ++i) {
    const double step = near / 2 + far / 2;
    const double reached = std::fabs(field_.distance(plus(site.at, sign * step, site.away)));
    (reached > step * (1 - 0x1p-40) ? near : far) = step;
  }
  return plus(site.at, sign * near, site.away);
}

Vec3 PointSource::far_away(test::Random& random) const {
  const double distance = size_ * (random.below(2) == 0 ? 1e3 : 1e9);
  Vec3 d = direction(random);
  if (random.below(3) == 0) d = {random.below(2) == 0 ? 1.0 : -1.0, 0, 0};
  return plus(some_vertex(random), distance, d);
}

Vec3 PointSource::draw(test::Random& random) const {
  const std::uint64_t dice = random.below(100);
  if (dice < 15) return random.in(test::scaled(box_, 1.5));
  if (dice < 30) return shaken(anywhere(random).at, size_, random);
  if (dice < 33) return anywhere(random).at;
  if (dice < 48) return plus(anywhere(random).at, distance(random), direction(random));
  if (dice < 75) {
    const Site site = anywhere(random);
    return plus(site.at, distance(random), site.away);
  }
  if (dice < 82) return in_common_plane(random);
  if (dice < 90) return with_borrowed_coordinates(random);
  if (dice < 97) {
    const Vec3 p = on_medial_axis(random);
    return random.below(2) == 0 ? p : shaken(p, size_, random);
  }
  return dice < 99 ? shaken(with_borrowed_coordinates(random), size_, random) : far_away(random);
}

}  // namespace cdfr::soak
