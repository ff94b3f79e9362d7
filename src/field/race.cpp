#include "field/race.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdfr {
namespace {

bool beats(const Winner& a, const Winner& b) noexcept {
  return b.slot == no_index || a.foot.squared < b.foot.squared ||
         (a.foot.squared == b.foot.squared && a.number < b.number);
}

}  // namespace

void Race::challenge(std::uint32_t slot) noexcept {
  const TriangleShape& shape = triangles_.shape(slot);
  const TriangleRecord& record = triangles_.records[slot];
  const PlaceEstimate estimate = estimate_place(p_, shape);
  const bool has_area = rounded(shape.normal) != Vec3{};
  if (has_area && shares_foot(estimate.place, record)) {
    Winner& best = proper_.winner;
    if (record.number > best.number) return;
    best.foot.place = estimate.place;
    best.slot = slot;
    best.number = record.number;
    return;
  }
  const Winner challenger{measure(p_, shape, estimate), slot, record.number};
  if (has_area) {
    challenge_proper(challenger);
  } else if (beats(challenger, flat_)) {
    flat_ = challenger;
  }
}

/// The kernel's foot on an edge or vertex is the same bits, whichever triangle it comes from, unless one of
/// them finds p on itself.
bool Race::shares_foot(TrianglePlace place, const TriangleRecord& record) const noexcept {
  return place != unsure_place && proper_.winner.foot.squared.hi > 0 && same_feature(place, record);
}

/// The kernel is within 2^-93 R of the truth, and R is at most 4 times the size; an edge may stand for a face
/// 2^-94 R beside it. So a distance that is larger by 2^-88 of the size is larger in truth.
bool Race::tied(DoubleDouble a, DoubleDouble b, double gap) noexcept {
  const double apart = (a - b).hi;
  const double farther = std::sqrt(std::max(a.hi, b.hi));
  return std::fabs(apart) <= 2 * gap * farther * (1 + 4 * unit_roundoff) + gap * gap;
}

void Race::challenge_proper(const Winner& challenger) noexcept {
  Winner& best = proper_.winner;
  if (best.slot == no_index) {
    best = challenger;
    return;
  }
  const bool is_tied = tied(challenger.foot.squared, best.foot.squared, gap(size_));
  const bool wins = beats(challenger, best);
  if (!is_tied && wins) {
    proper_.rival_count = 0;
    proper_.crowded = false;
  }
  if (is_tied && !same_feature(challenger.foot.place, triangles_.records[challenger.slot])) {
    add_rival(wins ? best.slot : challenger.slot);
  }
  if (wins) best = challenger;
}

void Race::add_rival(std::uint32_t slot) noexcept {
  if (proper_.rival_count == proper_.rivals.size()) {
    proper_.crowded = true;
  } else {
    proper_.rivals[proper_.rival_count++] = slot;
  }
}

bool Race::same_feature(TrianglePlace place, const TriangleRecord& record) const noexcept {
  const Winner& best = proper_.winner;
  if (best.slot == no_index) return false;
  const TrianglePlace other = best.foot.place;
  const TriangleRecord& others = triangles_.records[best.slot];
  if (place >= 4 && other >= 4) return record.vertices[place - 4] == others.vertices[other - 4];
  if (place >= 1 && place < 4 && other >= 1 && other < 4) {
    return record.edges[place - 1] == others.edges[other - 1];
  }
  return false;
}

Finding Race::finding() const noexcept {
  if (flat_.slot == no_index && proper_.winner.slot == no_index) {
    // Nobody came: a forged file may say that there is nobody near. No distance then.
    Finding none;
    none.winner.foot.squared.hi = std::numeric_limits<double>::quiet_NaN();
    none.winner.slot = 0;
    none.winner.number = triangles_.records[0].number;
    return none;
  }
  if (flat_.slot == no_index) return proper_;
  const Winner& proper = proper_.winner;
  // The kernel is within 2^-93 R of the truth, and R is at most 4 times the size.
  const bool closer = proper.slot == no_index || (proper.foot.squared - flat_.foot.squared).hi >
                                                     0x1p-89 * size_ * square_root(proper.foot.squared);
  if (!closer) return proper_;
  Finding finding;
  finding.winner = flat_;
  finding.crowded = true;
  return finding;
}

}  // namespace cdfr
