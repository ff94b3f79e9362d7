#include "geometry/sample_distances.h"

// Compiled once for each instruction set, with the rules of triangle_group.cpp: the same bits from every set.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/sample_distances.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, group_size>;
using Vector = hn::Vec<Tag>;

/// A function of the sample that is a sum of one term an axis.
struct Sum {
  Vector terms[3][5];
};

/// Terms of the dot product with a fixed vector.
HWY_INLINE void dot(const Sum& r, const Vector (&with)[3], Sum& product) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 5; ++i) product.terms[axis][i] = hn::Mul(r.terms[axis][i], with[axis]);
  }
}

/// One vertex and the edge from it to the next.
struct Edge {
  Sum squared;                   ///< |r|^2, r = sample minus vertex
  Sum along;                     ///< r.e
  Sum side;                      ///< r.(n x e): positive towards the inside
  Vector length, inverse, size;  ///< |e|^2, its inverse or 0, |e|_1
};

HWY_INLINE void place_edge(const Samples& samples, const TriangleGroup& group, std::size_t lane, int corner,
                           const Vector (&n)[3], Edge& edge, Sum& r) {
  const Tag d;
  Vector e[3];
  for (int axis = 0; axis < 3; ++axis) {
    const Vector v = hn::Load(d, group.vertices[corner][axis] + lane);
    e[axis] = hn::Sub(hn::Load(d, group.vertices[(corner + 1) % 3][axis] + lane), v);
    for (int i = 0; i < 5; ++i) {
      r.terms[axis][i] = hn::Sub(hn::Set(d, samples.places[axis][i]), v);
      edge.squared.terms[axis][i] = hn::Mul(r.terms[axis][i], r.terms[axis][i]);
    }
  }
  const Vector w[3] = {hn::Sub(hn::Mul(n[1], e[2]), hn::Mul(n[2], e[1])),
                       hn::Sub(hn::Mul(n[2], e[0]), hn::Mul(n[0], e[2])),
                       hn::Sub(hn::Mul(n[0], e[1]), hn::Mul(n[1], e[0]))};
  dot(r, e, edge.along);
  dot(r, w, edge.side);
  edge.length = hn::Add(hn::Add(hn::Mul(e[0], e[0]), hn::Mul(e[1], e[1])), hn::Mul(e[2], e[2]));
  const Vector one = hn::Set(d, 1.0);
  const auto long_enough = hn::Gt(edge.length, hn::Zero(d));
  edge.inverse = hn::IfThenElseZero(long_enough, hn::Div(one, hn::IfThenElse(long_enough, edge.length, one)));
  edge.size = hn::Add(hn::Add(hn::Abs(e[0]), hn::Abs(e[1])), hn::Abs(e[2]));
}

/// |r|^2 of the sample that is farthest away.
HWY_INLINE Vector farthest(const Edge& edge) {
  const auto& t = edge.squared.terms;
  return hn::Add(hn::Add(hn::Max(t[0][0], t[0][4]), hn::Max(t[1][0], t[1][4])), hn::Max(t[2][0], t[2][4]));
}

/// As many lanes as the instruction set has, from `lane` on.
class Lanes {
 public:
  HWY_INLINE Lanes(const Samples& samples, const TriangleGroup& group, std::size_t lane) {
    const Tag d;
    Vector n[3];
    for (int axis = 0; axis < 3; ++axis) n[axis] = hn::Load(d, group.normals[axis] + lane);
    Sum r;
    for (int corner = 2; corner >= 0; --corner)
      place_edge(samples, group, lane, corner, n, edges_[corner], r);
    dot(r, n, height_);  // over the first vertex
    const Vector most = hn::Max(hn::Max(farthest(edges_[0]), farthest(edges_[1])), farthest(edges_[2]));
    slack_ = hn::Mul(most, hn::Set(d, 128 * unit_roundoff));
    const Vector doubt = hn::Mul(hn::Sqrt(most), hn::Set(d, 16 * unit_roundoff));
    for (int k = 0; k < 3; ++k) limits_[k] = hn::Mul(doubt, edges_[k].size);
  }

  /// Samples at every second place of each axis from `first` on.
  HWY_INLINE void store(int first, std::size_t lane, GroupDistances* squared) const {
    const Tag d;
    for (int z = first; z < 5; z += 2) {
      for (int y = first; y < 5; y += 2) {
        for (int x = first; x < 5; x += 2) hn::StoreU(at(x, y, z), d, (squared++)->data() + lane);
      }
    }
  }

 private:
  HWY_INLINE Vector value(const Sum& sum, int x, int y, int z) const {
    return hn::Add(sum.terms[0][x], hn::Add(sum.terms[1][y], sum.terms[2][z]));
  }

  HWY_INLINE Vector to_edge(const Edge& edge, int x, int y, int z) const {
    const Tag d;
    const Vector along = value(edge.along, x, y, z);
    const Vector t = hn::Min(hn::Max(hn::Mul(along, edge.inverse), hn::Zero(d)), hn::Set(d, 1.0));
    const Vector less = hn::Mul(t, hn::Sub(hn::Add(along, along), hn::Mul(t, edge.length)));
    return hn::Sub(value(edge.squared, x, y, z), less);
  }

  HWY_INLINE Vector at(int x, int y, int z) const {
    const Vector border = hn::Min(hn::Min(to_edge(edges_[0], x, y, z), to_edge(edges_[1], x, y, z)),
                                  to_edge(edges_[2], x, y, z));
    const Vector height = value(height_, x, y, z);
    const auto inside = hn::And(hn::And(hn::Gt(value(edges_[0].side, x, y, z), limits_[0]),
                                        hn::Gt(value(edges_[1].side, x, y, z), limits_[1])),
                                hn::Gt(value(edges_[2].side, x, y, z), limits_[2]));
    return hn::Sub(hn::IfThenElse(inside, hn::Mul(height, height), border), slack_);
  }

  Edge edges_[3];
  Sum height_;
  Vector slack_, limits_[3];
};

void squared_distances_below_here(const Samples& samples, const TriangleGroup& group,
                                  SampleDistances& distances) {
  for (std::size_t lane = 0; lane < group_size; lane += hn::Lanes(Tag())) {
    const Lanes lanes(samples, group, lane);
    lanes.store(0, lane, distances.squared.data());
    lanes.store(1, lane, distances.squared.data() + corner_samples);
  }
}

void add_here(const SampleDistances& distances, std::uint32_t number, NearestOfSamples& nearest) {
  const Tag d;
  const Vector group = hn::Set(d, static_cast<double>(number));
  for (std::size_t sample = 0; sample < sample_count; ++sample) {
    for (std::size_t lane = 0; lane < group_size; lane += hn::Lanes(d)) {
      double* squared = nearest.squared[sample].data() + lane;
      double* groups = nearest.group[sample].data() + lane;
      const Vector least = hn::Load(d, squared);
      const Vector here = hn::Load(d, distances.squared[sample].data() + lane);
      const auto closer = hn::Lt(here, least);
      hn::Store(hn::IfThenElse(closer, here, least), d, squared);
      hn::Store(hn::IfThenElse(closer, group, hn::Load(d, groups)), d, groups);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <cmath>

namespace cdfr {

HWY_EXPORT(squared_distances_below_here);
HWY_EXPORT(add_here);

Samples::Samples(const Vec3& lo, double edge) noexcept {
  const double from[3] = {lo.x, lo.y, lo.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < 5; ++i) places[axis][i] = from[axis] + static_cast<double>(i) * (edge / 2);
  }
}

Vec3 Samples::point(std::size_t sample) const noexcept {
  if (sample < corner_samples) {
    return {places[0][2 * (sample % 3)], places[1][2 * (sample / 3 % 3)], places[2][2 * (sample / 9)]};
  }
  const std::size_t child = sample - corner_samples;
  return {places[0][2 * (child & 1) + 1], places[1][2 * (child >> 1 & 1) + 1],
          places[2][2 * (child >> 2) + 1]};
}

void squared_distances_below(const Samples& samples, const TriangleGroup& group,
                             SampleDistances& distances) noexcept {
  HWY_DYNAMIC_DISPATCH(squared_distances_below_here)(samples, group, distances);
}

std::array<double, sample_count> squared_distances_below(const Samples& samples, const Box& box) noexcept {
  const double lo[3] = {box.lo.x, box.lo.y, box.lo.z}, hi[3] = {box.hi.x, box.hi.y, box.hi.z};
  double terms[3][5];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < 5; ++i) {
      const double at = samples.places[axis][i];
      const double away = std::max(std::max(lo[axis] - at, at - hi[axis]), 0.0);
      terms[axis][i] = away * away * (1 - 8 * unit_roundoff);
    }
  }
  std::array<double, sample_count> squared;
  std::size_t next = 0;
  for (std::size_t first = 0; first < 2; ++first) {
    for (std::size_t z = first; z < 5; z += 2) {
      for (std::size_t y = first; y < 5; y += 2) {
        const double yz = terms[1][y] + terms[2][z];
        for (std::size_t x = first; x < 5; x += 2) squared[next++] = terms[0][x] + yz;
      }
    }
  }
  return squared;
}

void NearestOfSamples::clear() noexcept {
  for (GroupDistances& lanes : squared) lanes.fill(HUGE_VAL);
}

void NearestOfSamples::add(const SampleDistances& distances, std::uint32_t number) noexcept {
  HWY_DYNAMIC_DISPATCH(add_here)(distances, number, *this);
}

std::uint32_t NearestOfSamples::slot(std::size_t sample) const noexcept {
  const auto slot_of = [&](std::size_t lane) {
    return static_cast<std::uint32_t>(group[sample][lane]) * static_cast<std::uint32_t>(group_size) +
           static_cast<std::uint32_t>(lane);
  };
  const GroupDistances& lanes = squared[sample];
  std::size_t best = 0;
  for (std::size_t lane = 1; lane < group_size; ++lane) {
    if (lanes[lane] < lanes[best] || (lanes[lane] == lanes[best] && slot_of(lane) < slot_of(best)))
      best = lane;
  }
  return slot_of(best);
}

}  // namespace cdfr
#endif
