#include "field/sign.h"

#include <array>
#include <cmath>

#include "core/arithmetic.h"
#include "core/parallel.h"
#include "core/vector.h"

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

std::array<double, 3> angles_of(const TriangleShape& triangle) noexcept {
  if (flat(triangle.normal)) return {};
  std::array<double, 3> angles;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto along = [&](std::size_t other) {
      return rounded(difference(triangle.vertices[other], triangle.vertices[k]));
    };
    angles[k] = angle_between(along((k + 1) % 3), along((k + 2) % 3));
  }
  return angles;
}

}  // namespace

Pseudonormals pseudonormals(const TriangleStore& store, std::size_t edge_count, std::size_t vertex_count,
                            std::span<const std::uint8_t> plain_edges,
                            std::span<const std::uint8_t> plain_vertices, const Scratch* scratch) {
  Large<Sum> edges(edge_count, scratch);
  Large<Sum> vertices(vertex_count, scratch);
  Large<std::array<double, 3>> angles(store.size(), scratch);
  for_chunks(angles.size(), 1024, [&](std::size_t first, std::size_t end) {
    for (std::size_t slot = first; slot < end; ++slot) {
      angles[slot] = angles_of(store.shape(static_cast<std::uint32_t>(slot)));
    }
  });
  // In input order, so that sums do not depend on the BVH.
  Large<std::uint32_t> slot_of(store.size(), scratch);
  for (std::uint32_t slot = 0; slot < store.size(); ++slot) slot_of[store.records[slot].number] = slot;
  for (const std::uint32_t slot : slot_of) {
    const DoubleDouble3 normal = store.shape(slot).normal;
    const TriangleRecord& record = store.records[slot];
    for (int k = 0; k < 3; ++k) {
      if (record.edges[k] != no_index) edges[record.edges[k]].add(normal, 1);
      vertices[record.vertices[k]].add(normal, angles[slot][k]);
    }
  }
  const auto is_plain = [](std::span<const std::uint8_t> plain, std::size_t i) {
    return plain.empty() || plain[i] != 0;
  };
  Large<Vec3> edge_normals(edges.size(), scratch), vertex_normals(vertices.size(), scratch);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_plain(plain_edges, i)) edge_normals[i] = edge_normal(edges[i]);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (is_plain(plain_vertices, i)) vertex_normals[i] = vertex_normal(vertices[i]);
  }
  return {std::move(edge_normals), std::move(vertex_normals)};
}

int side_of_normal(const Foot& foot, const Vec3& normal, double reach) noexcept {
  const Eigen::Vector3d offset = to_eigen(rounded(foot.offset));
  const Eigen::Vector3d n = to_eigen(normal);
  const double product = offset.dot(n);
  // Edge: offset, normal, product and two sums round by less than 8u of |offset|_1 |n|_1, and each of the two
  // unit normals is off by 2^-98, which counts where they nearly cancel. Vertex: the mean normal is within
  // 2^-42 (vertex_normal). The offset itself may be off by 2^-93 R in all: by the kernel's rounding, and
  // where the true foot is beside the edge or vertex, so near that the kernel could not tell.
  const double doubt = foot.place < 4 ? 16 * unit_roundoff * n.lpNorm<1>() + 0x1p-94 : 0x1p-40;
  const double bound = offset.lpNorm<1>() * doubt + 0x1p-90 * reach * n.lpNorm<1>();
  if (product > bound) return 1;
  return product < -bound ? -1 : 0;
}

}  // namespace cdfr
