#include "field/sign.h"

#include <cmath>

#include "core/arithmetic.h"
#include "core/vector.h"
#include "mesh/crossings.h"

namespace cdfr {
namespace {

bool flat(const DoubleDouble3& normal) noexcept { return rounded(normal) == Vec3{}; }

/// Sums of what touches each edge or vertex; `hidden` where a triangle of no area does.
struct Sum {
  DoubleDouble3 normal{};
  double weight = 0;
  std::uint32_t count = 0;
  bool hidden = false;

  void add(const DoubleDouble3& n, double w) noexcept {
    hidden |= flat(n);
    for (int i = 0; i < 3; ++i) normal[i] = normal[i] + n[i] * w;
    weight += w;
    ++count;
  }
};

Vec3 edge_normal(const Sum& sum) noexcept { return sum.hidden ? Vec3{} : rounded(sum.normal); }

/// Edge vectors are rounded before their angle is taken, so each weight is off by up to 4u, however small it
/// is, and by 16u of itself. Where the mean angle is 2^-9 or more that shifts the mean normal by less than
/// 2^-42; sharper tips are left to the crossings.
Vec3 vertex_normal(const Sum& sum) noexcept {
  if (sum.hidden || !(sum.weight * 0x1p9 >= sum.count)) return {};
  const Vec3 n = rounded(sum.normal);
  return {n.x / sum.weight, n.y / sum.weight, n.z / sum.weight};
}

double angle_at(const TriangleShape& triangle, int corner) noexcept {
  const auto along = [&](int other) {
    return rounded(difference(triangle.vertices[other], triangle.vertices[corner]));
  };
  return angle_between(along((corner + 1) % 3), along((corner + 2) % 3));
}

}  // namespace

Pseudonormals pseudonormals(const Topology& topology, const TriangleStore& store) {
  std::vector<Sum> edges(topology.edges.size());
  std::vector<Sum> vertices(topology.vertex_count);
  // In input order, so that sums do not depend on the BVH.
  std::vector<std::uint32_t> slot_of(store.size());
  for (std::uint32_t slot = 0; slot < store.size(); ++slot) slot_of[store.records[slot].number] = slot;
  for (const std::uint32_t slot : slot_of) {
    const TriangleShape shape = store.shape(slot);
    const TriangleRecord& record = store.records[slot];
    for (int k = 0; k < 3; ++k) {
      if (record.edges[k] != no_index) edges[record.edges[k]].add(shape.normal, 1);
      vertices[record.vertices[k]].add(shape.normal, flat(shape.normal) ? 0 : angle_at(shape, k));
    }
  }
  Pseudonormals result;
  result.edges.reserve(edges.size());
  for (const Sum& sum : edges) result.edges.push_back(edge_normal(sum));
  result.vertices.reserve(vertices.size());
  for (const Sum& sum : vertices) result.vertices.push_back(vertex_normal(sum));
  return result;
}

int side_of(const Vec3& p, const Foot& foot, std::uint32_t slot, SearchSpace space,
            const Pseudonormals& normals) noexcept {
  if (foot.squared.hi == 0) return 0;
  if (foot.place == 0) return foot.along.hi > 0 ? 1 : -1;
  const TriangleRecord& record = space.triangles.records[slot];
  const bool on_edge = foot.place < 4;
  const Vec3 normal = on_edge ? normals.edges[record.edges[foot.place - 1]]
                              : normals.vertices[record.vertices[foot.place - 4]];
  const Eigen::Vector3d offset = to_eigen(rounded(foot.offset));
  const Eigen::Vector3d n = to_eigen(normal);
  const double product = offset.dot(n);
  // Edge: offset, normal, product and two sums round by less than 8u of |offset|_1 |n|_1, and each of the two
  // unit normals is off by 2^-98, which counts where they nearly cancel. Vertex: the mean normal is within
  // 2^-42 (vertex_normal).
  const double doubt = on_edge ? 16 * unit_roundoff * n.lpNorm<1>() + 0x1p-94 : 0x1p-40;
  const double bound = offset.lpNorm<1>() * doubt;
  if (product > bound) return 1;
  if (product < -bound) return -1;
  return winding_by_crossings(p, space) > 0 ? -1 : 1;
}

}  // namespace cdfr
