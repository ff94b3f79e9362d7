#include "export/icosphere.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "cdfr/core/types.h"

namespace cdfr {
namespace {

constexpr int cuts = 3;

double dot(Vec3 u, Vec3 v) noexcept { return u.x * v.x + u.y * v.y + u.z * v.z; }

Vec3 cross(Vec3 u, Vec3 v) noexcept {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

Vec3 on_sphere(Vec3 v) noexcept {
  const double length = std::sqrt(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

struct Ball {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// Corners (0, +-1, +-g) and what turning the axes round makes of them, g the golden ratio. Two of them are
/// neighbours if they are less than a right angle apart, and three neighbours make a triangle.
Ball icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  Ball ball;
  for (const double one : {-1.0, 1.0}) {
    for (const double g : {-golden, golden}) {
      for (const Vec3 v : {Vec3{0, one, g}, Vec3{g, 0, one}, Vec3{one, g, 0}})
        ball.vertices.push_back(on_sphere(v));
    }
  }
  const auto near = [&](std::uint32_t a, std::uint32_t b) {
    return dot(ball.vertices[a], ball.vertices[b]) > 0;
  };
  for (std::uint32_t a = 0; a < 12; ++a) {
    for (std::uint32_t b = a + 1; b < 12; ++b) {
      for (std::uint32_t c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
        const bool outward = dot(ball.vertices[a], cross(ball.vertices[b], ball.vertices[c])) > 0;
        ball.triangles.push_back(outward ? Triangle{a, b, c} : Triangle{a, c, b});
      }
    }
  }
  return ball;
}

void cut(Ball& ball) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(ball.vertices.size()));
    if (is_new) {
      const Vec3 u = ball.vertices[a], v = ball.vertices[b];
      ball.vertices.push_back(on_sphere({u.x + v.x, u.y + v.y, u.z + v.z}));
    }
    return found->second;
  };
  std::vector<Triangle> smaller;
  for (const auto& [a, b, c] : ball.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    smaller.insert(smaller.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  ball.triangles = std::move(smaller);
}

}  // namespace

Icosphere icosphere() {
  Ball ball = icosahedron();
  for (int i = 0; i < cuts; ++i) cut(ball);
  Icosphere sphere;
  for (const Vec3& v : ball.vertices) {
    sphere.vertices.push_back({static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
  }
  for (const Triangle& triangle : ball.triangles) {
    sphere.corners.insert(sphere.corners.end(), triangle.begin(), triangle.end());
  }
  return sphere;
}

}  // namespace cdfr
