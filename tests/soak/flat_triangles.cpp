#include "soak/flat_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <vector>

#include "soak/welded.h"

namespace cdfr::soak {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

class Flipper {
 public:
  Flipper(const Mesh& mesh, const DirectedEdges& edges)
      : mesh_(mesh), edges_(edges), gone_(mesh.triangles.size(), false) {}

  /// Flips a flat triangle whose neighbour is proper, or has the same longest edge and so shrinks too. True
  /// if there was none that could not be.
  bool flip_all() {
    std::vector<std::uint32_t> flat = flat_triangles();
    // Each round shortens the longest edges; a mesh of n flat triangles is done in n rounds or never.
    for (std::size_t round = 0; !flat.empty() && round <= mesh_.triangles.size(); ++round) {
      bool flipped = false;
      for (const std::uint32_t t : flat) {
        if (gone_[t] || !is_flat(t) || !may_flip(t)) continue;
        if (!flip(t)) return false;
        flipped = true;
      }
      if (!flipped) break;
      flat = flat_triangles();
    }
    return flat.empty();
  }

  Mesh result() const {
    Mesh result;
    result.vertices = mesh_.vertices;
    for (std::size_t t = 0; t < gone_.size(); ++t) {
      if (!gone_[t]) result.triangles.push_back(mesh_.triangles[t]);
    }
    return welded(result);
  }

 private:
  Kernel::Point_3 point(std::uint32_t vertex) const {
    const Vec3& v = mesh_.vertices[vertex];
    return {v.x, v.y, v.z};
  }
  bool is_flat(std::uint32_t t) const {
    const Triangle& v = mesh_.triangles[t];
    return CGAL::collinear(point(v[0]), point(v[1]), point(v[2]));
  }
  std::vector<std::uint32_t> flat_triangles() const {
    std::vector<std::uint32_t> flat;
    for (std::uint32_t t = 0; t < gone_.size(); ++t) {
      if (!gone_[t] && is_flat(t)) flat.push_back(t);
    }
    return flat;
  }

  /// The corner of a flat triangle that is between the two others.
  std::size_t middle(std::uint32_t t) const {
    const Triangle& v = mesh_.triangles[t];
    for (std::size_t k = 0; k < 2; ++k) {
      if (CGAL::collinear_are_strictly_ordered_along_line(point(v[(k + 2) % 3]), point(v[k]),
                                                          point(v[(k + 1) % 3])))
        return k;
    }
    return 2;
  }

  std::uint32_t across_longest(std::uint32_t t) const {
    const std::size_t k = middle(t);
    const Triangle& v = mesh_.triangles[t];
    return edges_.at(v[(k + 2) % 3], v[(k + 1) % 3]);
  }
  bool may_flip(std::uint32_t t) const {
    const std::uint32_t other = across_longest(t);
    return !is_flat(other) || across_longest(other) == t;
  }

  void remove(std::uint32_t t) {
    const Triangle& v = mesh_.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) edges_.remove(v[k], v[(k + 1) % 3]);
    gone_[t] = true;
  }
  bool put(std::uint32_t t, const Triangle& v) {
    mesh_.triangles[t] = v;
    gone_[t] = false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!edges_.add(v[k], v[(k + 1) % 3], t)) return false;
    }
    return true;
  }

  /// (b, c, a), b in the middle, and (a, c, d) become (b, c, d) and (b, d, a); both go if d is b.
  bool flip(std::uint32_t t) {
    const std::size_t k = middle(t);
    const Triangle v = mesh_.triangles[t];
    const std::uint32_t b = v[k], c = v[(k + 1) % 3], a = v[(k + 2) % 3], other = across_longest(t);
    const Triangle w = mesh_.triangles[other];
    const std::uint32_t d = w[0] != a && w[0] != c ? w[0] : (w[1] != a && w[1] != c ? w[1] : w[2]);
    remove(t);
    remove(other);
    return d == b || (put(t, {b, c, d}) && put(other, {b, d, a}));
  }

  Mesh mesh_;
  DirectedEdges edges_;
  std::vector<bool> gone_;
};

}  // namespace

std::optional<Mesh> without_flat_triangles(const Mesh& mesh, const DirectedEdges& edges) {
  Flipper flipper(mesh, edges);
  if (!flipper.flip_all()) return std::nullopt;
  return flipper.result();
}

}  // namespace cdfr::soak
