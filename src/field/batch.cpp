#include "field/batch.h"

#include <algorithm>
#include <array>

#include "core/floating_environment.h"
#include "field/contests.h"
#include "field/query.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Points that are under way together.
constexpr std::size_t bundle_size = 32;

class Bundle {
 public:
  struct Point {
    Vec3 x;
    bool in_leaf = false;  ///< answered by a leaf's list; others go the ordinary way
    std::uint32_t leaf = 0;
    Query query;
    LatticePoint place;
    Located located;
    Shortlist shortlist;
    Candidates candidates;
  };

  explicit Bundle(const FieldData& field) noexcept : field_(field) {}

  /// Precondition: count <= bundle_size.
  std::span<const Point> scanned(Points x, std::size_t first, std::size_t count) noexcept {
    count_ = count;
    for (std::size_t i = 0; i < count_; ++i) points_[i].x = x[first + i];
    find_leaves();
    find_lists();
    shorten_lists();
    scan_lists();
    return {points_.data(), count_};
  }

 private:
  void find_leaves() noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      Point& p = points_[i];
      p.in_leaf = false;
      if (!is_finite(p.x)) continue;
      p.query = admitted(field_, p.x);
      p.in_leaf = field_.index.contains(p.query.p);
      if (!p.in_leaf) continue;
      p.place = field_.index.place(p.query.p);
      p.leaf = field_.index.leaf(p.place);
      field_.index.prefetch(p.leaf);
    }
  }

  void find_lists() noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      Point& p = points_[i];
      if (!p.in_leaf) continue;
      p.located = field_.index.at(p.place, p.leaf);
      __builtin_prefetch(p.located.entries.data());
    }
  }

  void shorten_lists() noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      Point& p = points_[i];
      if (p.in_leaf) shorten(field_.scan_groups.data(), p.located, p.shortlist);
    }
  }

  void scan_lists() noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      Point& p = points_[i];
      if (!p.in_leaf) continue;
      scan(field_.scan_space(), p.query.p, p.place.at, p.located, p.shortlist, p.candidates);
      if (!p.candidates.complete) continue;
      for (std::uint32_t k = 0; k < p.candidates.count; ++k) field_.triangles.prefetch(p.candidates.slots[k]);
    }
  }

  const FieldData& field_;
  std::size_t count_ = 0;
  std::array<Point, bundle_size> points_;
};

Finding finding_of(const FieldData& field, const Bundle::Point& p) noexcept {
  return closest_in_leaf(field, p.query.p, p.located, p.candidates);
}

/// Distances: candidates meet the kernel in lanes.
class Distances {
 public:
  Distances(const FieldData& field, std::span<double> out) noexcept
      : field_(field), out_(out), alone_(field, out), several_(field, out) {}

  void take(std::size_t place, const Bundle::Point& p) noexcept {
    const std::size_t count = p.candidates.count;
    if (!p.in_leaf) {
      out_[place] = signed_distance(field_, p.x);
    } else if (!p.candidates.complete || count - 1 >= Contests::most || p.query.scale != 1) {
      out_[place] = signed_distance(field_, p.query, finding_of(field_, p));
    } else {
      (count == 1 ? alone_ : several_)
          .add(place, p.query.p, p.located.side, {p.candidates.slots.data(), count});
    }
  }
  void finish() noexcept {
    alone_.settle();
    several_.settle();
  }

 private:
  const FieldData& field_;
  std::span<double> out_;
  // Apart, since these lie on faces mostly, and those on edges and vertices.
  Contests alone_, several_;
};

class ClosestPoints {
 public:
  ClosestPoints(const FieldData& field, std::span<Closest> out) noexcept : field_(field), out_(out) {}

  void take(std::size_t place, const Bundle::Point& p) noexcept {
    out_[place] = p.in_leaf ? closest_point(field_, p.query, finding_of(field_, p))
                            : closest_point(field_, p.x, Finder::tree);
  }
  void finish() noexcept {}

 private:
  const FieldData& field_;
  std::span<Closest> out_;
};

template <class Answers, class Answer>
bool answer_all(const FieldData& field, Points x, std::size_t first, std::span<Answer> out,
                Progress& progress) {
  const FloatingEnvironment environment;
  Bundle bundle(field);
  Answers answers(field, out);
  for (std::size_t i = 0; i < out.size(); i += bundle_size) {
    if (!progress.poll()) return false;
    const auto points = bundle.scanned(x, first + i, std::min(bundle_size, out.size() - i));
    for (std::size_t k = 0; k < points.size(); ++k) answers.take(i + k, points[k]);
  }
  answers.finish();
  return true;
}

}  // namespace

bool answer(const FieldData& field, Points x, std::size_t first, std::span<double> out, Progress& progress) {
  return answer_all<Distances>(field, x, first, out, progress);
}

bool answer(const FieldData& field, Points x, std::size_t first, std::span<Closest> out, Progress& progress) {
  return answer_all<ClosestPoints>(field, x, first, out, progress);
}

}  // namespace cdfr
