#include "field/batch.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/floating_environment.h"
#include "field/query.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Entries of a list whose groups are called for before it is looked through.
constexpr std::size_t called_groups = 4;

class Bundle {
 public:
  Bundle(const FieldData& field, Points x, std::size_t first, std::size_t count) noexcept
      : field_(field), count_(count) {
    assert(count <= bundle_size);
    for (std::size_t i = 0; i < count_; ++i) points_[i].x = x[first + i];
  }

  template <class Answer>
  void run(std::span<Answer> out) noexcept {
    find_leaves();
    find_lists();
    call_for_groups();
    scan_lists();
    for (std::size_t i = 0; i < count_; ++i) answer(points_[i], out[i]);
  }

 private:
  struct Point {
    Vec3 x;
    bool in_leaf = false;  ///< answered by a leaf's list; others go the ordinary way
    bool scanned = false;  ///< the candidates are complete
    std::uint32_t leaf = 0;
    Query query;
    LatticePoint place;
    Located located;
    Candidates candidates;
  };

  void find_leaves() noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      Point& p = points_[i];
      if (!is_finite(p.x)) continue;
      p.query = admitted(field_, p.x);
      p.in_leaf = !field_.index.empty() && field_.index.contains(p.query.p);
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

  void call_for_groups() const noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      if (!points_[i].in_leaf) continue;
      const std::span<const Entry> list = points_[i].located.entries;
      for (std::size_t k = 0; k < std::min(called_groups, list.size()); ++k) {
        if (list[k].is_group()) prefetch(field_.scan_groups[list[k].number()]);
      }
    }
  }

  void scan_lists() noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      Point& p = points_[i];
      if (!p.in_leaf) continue;
      p.scanned =
          scan(field_.scan_groups.data(), p.located.entries, p.place.at, p.located.from_centre, p.candidates);
      if (!p.scanned) continue;
      for (std::uint32_t k = 0; k < p.candidates.count; ++k) field_.triangles.prefetch(p.candidates.slots[k]);
    }
  }

  Finding finding_of(const Point& p) const noexcept {
    Finding finding = p.scanned ? closest_among(field_, p.query.p, p.candidates)
                                : closest_in_list(field_, p.query.p, p.located);
    finding.leaf = p.located.side;
    return finding;
  }

  void answer(const Point& p, double& out) const noexcept {
    out = p.in_leaf ? signed_distance(field_, p.query, finding_of(p)) : signed_distance(field_, p.x);
  }
  void answer(const Point& p, Closest& out) const noexcept {
    out =
        p.in_leaf ? closest_point(field_, p.query, finding_of(p)) : closest_point(field_, p.x, Finder::tree);
  }

  const FieldData& field_;
  std::size_t count_;
  std::array<Point, bundle_size> points_;
};

template <class Answer>
void answer_all(const FieldData& field, Points x, std::size_t first, std::span<Answer> out) noexcept {
  const FloatingEnvironment environment;
  Bundle(field, x, first, out.size()).run(out);
}

}  // namespace

void answer_bundle(const FieldData& field, Points x, std::size_t first, std::span<double> out) noexcept {
  answer_all(field, x, first, out);
}

void answer_bundle(const FieldData& field, Points x, std::size_t first, std::span<Closest> out) noexcept {
  answer_all(field, x, first, out);
}

}  // namespace cdfr
