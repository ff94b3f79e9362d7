#include "mesh/topology.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace cdfr {
namespace {

/// A vertex with a hash of its position: records of 16 bytes sort in half the time of whole positions.
struct Hashed {
  std::uint64_t hash = 0;
  std::uint32_t vertex = 0;
};

std::uint64_t mixed(std::uint64_t hash, double x) noexcept {
  // Adding zero turns -0 into 0, so that what is equal has equal bits.
  hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15U;
  return hash ^ (hash >> 29);
}

std::uint64_t hash_of(const Vec3& p) noexcept { return mixed(mixed(mixed(0, p.x), p.y), p.z); }

bool before(const Vec3& a, const Vec3& b) noexcept {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// Sorts vertices of one hash by position, then number. As a rule they are all at one place and in order
/// already.
void sort_run(const Points& vertices, std::span<Hashed> run) {
  const Vec3 first = vertices[run.front().vertex];
  const auto same_place = [&](const Hashed& item) { return vertices[item.vertex] == first; };
  if (std::all_of(run.begin(), run.end(), same_place)) return;
  std::sort(run.begin(), run.end(), [&](const Hashed& a, const Hashed& b) {
    const Vec3 p = vertices[a.vertex], q = vertices[b.vertex];
    return p == q ? a.vertex < b.vertex : before(p, q);
  });
}

/// All vertices by hash, then number: filed by the high bits of the hash, and each file sorted by itself.
Large<Hashed> sorted_by_hash(const Points& vertices, const Scratch* scratch) {
  const std::size_t files = std::bit_floor(vertices.size() / 4 + 1);
  const int shift = 64 - static_cast<int>(std::bit_width(files - 1));
  const auto file_of = [&](std::uint64_t hash) { return shift == 64 ? 0 : hash >> shift; };
  Large<std::uint64_t> starts(files + 1, 0, scratch);
  for (std::size_t i = 0; i < vertices.size(); ++i) ++starts[file_of(hash_of(vertices[i])) + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  Large<Hashed> items(vertices.size(), scratch);
  auto next = starts;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::uint64_t hash = hash_of(vertices[i]);
    items[next[file_of(hash)]++] = {hash, static_cast<std::uint32_t>(i)};
  }
  for (std::size_t file = 0; file < files; ++file) {
    const auto first = items.begin();
    std::sort(first + static_cast<std::ptrdiff_t>(starts[file]),
              first + static_cast<std::ptrdiff_t>(starts[file + 1]), [](const Hashed& x, const Hashed& y) {
                return x.hash != y.hash ? x.hash < y.hash : x.vertex < y.vertex;
              });
  }
  return items;
}

/// For each vertex the lowest vertex number with the same position.
Large<std::uint32_t> lowest_equal(const Points& vertices, const Scratch* scratch) {
  Large<Hashed> items = sorted_by_hash(vertices, scratch);
  Large<std::uint32_t> lowest(items.size(), scratch);
  for (std::size_t start = 0; start < items.size();) {
    std::size_t end = start + 1;
    while (end < items.size() && items[end].hash == items[start].hash) ++end;
    const auto run = std::span(items).subspan(start, end - start);
    if (run.size() > 1) sort_run(vertices, run);
    std::uint32_t first = run.front().vertex;
    for (const Hashed& item : run) {
      if (vertices[item.vertex] != vertices[first]) first = item.vertex;
      lowest[item.vertex] = first;
    }
    start = end;
  }
  return lowest;
}

void weld_corners(const MeshView& mesh, Topology& topology, const Scratch* scratch) {
  const Large<std::uint32_t> lowest = lowest_equal(mesh.vertices, scratch);
  Large<std::uint32_t> id(lowest.size(), no_index, scratch);
  topology.triangles.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& welded = id[lowest[mesh.triangles[t][k]]];
      if (welded == no_index) welded = topology.vertex_count++;
      topology.triangles[t][k] = welded;
    }
  }
}

/// A side of a triangle, filed under its low vertex.
struct Side {
  std::uint32_t high = 0;
  std::uint64_t corner = 0;  ///< 3 * triangle + k, so that equal ends sort by triangle
  bool operator<(const Side& other) const noexcept {
    return std::tie(high, corner) < std::tie(other.high, other.corner);
  }
};

template <class Visit>
void for_each_side(std::span<const Triangle> triangles, Visit visit) {
  for (std::uint64_t t = 0; t < triangles.size(); ++t) {
    for (std::uint64_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[t][k], to = triangles[t][(k + 1) % 3];
      if (from != to) visit(std::min(from, to), Side{std::max(from, to), 3 * t + k});
    }
  }
}

/// The sides by low vertex, high vertex and corner; those of low vertex v are [starts[v], starts[v + 1]).
struct SortedSides {
  Large<std::uint64_t> starts;
  Large<Side> sides;
};

SortedSides sort_sides(const Topology& topology, const Scratch* scratch) {
  SortedSides sorted{Large<std::uint64_t>(std::size_t{topology.vertex_count} + 1, 0, scratch),
                     Large<Side>(scratch)};
  auto& starts = sorted.starts;
  for_each_side(topology.triangles, [&](std::uint32_t low, const Side&) { ++starts[low + 1]; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  sorted.sides.resize(starts.back());
  auto next = starts;
  for_each_side(topology.triangles,
                [&](std::uint32_t low, const Side& side) { sorted.sides[next[low]++] = side; });
  for (std::size_t low = 0; low + 1 < starts.size(); ++low) {
    const auto first = sorted.sides.begin();
    std::sort(first + static_cast<std::ptrdiff_t>(starts[low]),
              first + static_cast<std::ptrdiff_t>(starts[low + 1]));
  }
  return sorted;
}

void add_side(std::uint32_t low, const Side& side, bool is_new_edge, Topology& topology) {
  if (is_new_edge) topology.edges.push_back({{low, side.high}, topology.uses.size()});
  const auto triangle = static_cast<std::uint32_t>(side.corner / 3);
  const std::size_t k = side.corner % 3;
  topology.edges_of[triangle][k] = static_cast<std::uint32_t>(topology.edges.size() - 1);
  topology.uses.push_back({triangle, topology.triangles[triangle][k] == low});
}

void join_edges(Topology& topology, const Scratch* scratch) {
  const auto [starts, sides] = sort_sides(topology, scratch);
  topology.edges_of.assign(topology.triangles.size(), {no_index, no_index, no_index});
  topology.edges.reserve(sides.size() / 2);
  topology.uses.reserve(sides.size());
  for (std::uint32_t low = 0; low < topology.vertex_count; ++low) {
    for (std::uint64_t i = starts[low]; i < starts[low + 1]; ++i) {
      add_side(low, sides[i], i == starts[low] || sides[i].high != sides[i - 1].high, topology);
    }
  }
}

}  // namespace

Topology weld_topology(MeshView mesh, const Scratch* scratch) {
  Topology topology(scratch);
  weld_corners(mesh, topology, scratch);
  join_edges(topology, scratch);
  return topology;
}

}  // namespace cdfr
