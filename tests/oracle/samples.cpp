#include "oracle/samples.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/shapes.h"
#include "oracle/vectors.h"

namespace cdfr::oracle {
namespace {

class Sampler {
 public:
  Sampler(Random& random, MeshView mesh, const Field& field)
      : random_(random), mesh_(mesh), field_(field), bounds_(field.bounds()) {
    const Vec3 size = minus(bounds_.hi, bounds_.lo);
    longest_ = std::max({size.x, size.y, size.z});
    centre_ = plus(bounds_.lo, 0.5, size);
  }

  Vec3 point(std::size_t turn) {
    switch (turn % 9) {
      case 0:
        return in_box();
      case 1:
        return plus(inside(), longest_ * random_.power_of_ten(-14, -2), random_.direction());
      case 2:
        return corners()[random_.below(3)];
      case 3:
        return on_edge();
      case 4:
        return inside();
      case 5:
        return on_leaf();
      case 6:
        return plus(on_edge(), longest_ * random_.power_of_ten(-17, -8), random_.direction());
      case 7:
        return on_leaf();
      default:
        return plus(centre_, longest_ * (turn % 2 == 0 ? 10 : 1000), random_.direction());
    }
  }

 private:
  Vec3 in_box() {
    const auto within = [&](double low, double high) {
      const double margin = 0.1 * (high - low);
      return random_.between(low - margin, high + margin);
    };
    const double x = within(bounds_.lo.x, bounds_.hi.x);
    const double y = within(bounds_.lo.y, bounds_.hi.y);
    return {x, y, within(bounds_.lo.z, bounds_.hi.z)};
  }

  Corners corners() {
    const Triangle& t = mesh_.triangles[random_.below(mesh_.triangles.size())];
    return {mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]};
  }

  Vec3 on_edge() {
    const Corners v = corners();
    return plus(v[0], random_.below(3) == 0 ? 0.5 : random_.unit(), minus(v[1], v[0]));
  }

  Vec3 inside() {
    const Corners v = corners();
    const double s = random_.unit();
    const double t = (1 - s) * random_.unit();
    return plus(plus(v[0], s, minus(v[1], v[0])), t, minus(v[2], v[0]));
  }

  /// Each coordinate on the leaf's low or high side, in its middle or anywhere, but not all of them anywhere.
  Vec3 on_leaf() {
    const Box box = field_.leaf(random_.below(field_.leaf_count())).box;
    const std::uint64_t fixed = random_.below(3);
    std::uint64_t axis = 0;
    const auto coordinate = [&](double low, double high) {
      switch (random_.below(axis++ == fixed ? 3 : 4)) {
        case 0:
          return low;
        case 1:
          return high;
        case 2:
          return low + (high - low) / 2;
        default:
          return random_.between(low, high);
      }
    };
    const double x = coordinate(box.lo.x, box.hi.x);
    const double y = coordinate(box.lo.y, box.hi.y);
    return {x, y, coordinate(box.lo.z, box.hi.z)};
  }

  Random& random_;
  MeshView mesh_;
  const Field& field_;
  Box bounds_;
  double longest_ = 0;
  Vec3 centre_;
};

}  // namespace

std::vector<Vec3> model_points(Random& random, MeshView mesh, const Field& field, std::size_t count) {
  Sampler sampler(random, mesh, field);
  std::vector<Vec3> points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = sampler.point(i);
  return points;
}

}  // namespace cdfr::oracle
