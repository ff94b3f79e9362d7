#include "field/race.h"

#include <algorithm>
#include <cmath>

namespace cdfr {
namespace {

bool beats(const Winner& a, const Winner& b) noexcept {
  return b.slot == no_index || a.foot.squared < b.foot.squared ||
         (a.foot.squared == b.foot.squared && a.number < b.number);
}

}  // namespace

void Race::challenge(std::uint32_t slot) noexcept {
  const TriangleShape shape = triangles_.shape(slot);
  const Winner challenger{measure(p_, shape), slot, triangles_.records[slot].number};
  if (rounded(shape.normal) != Vec3{}) {
    challenge_proper(challenger);
  } else if (beats(challenger, flat_)) {
    flat_ = challenger;
  }
}

/// The kernel is within 2^-93 R of the truth, and R is at most 4 times the size; an edge may stand for a face
/// 2^-94 R beside it. So a distance that is larger by 2^-88 of the size is larger in truth.
void Race::challenge_proper(const Winner& challenger) noexcept {
  Winner& best = proper_.winner;
  if (best.slot == no_index) {
    best = challenger;
    return;
  }
  const double gap = 0x1p-88 * size_;
  const double apart = (challenger.foot.squared - best.foot.squared).hi;
  const double farther = std::sqrt(std::max(challenger.foot.squared.hi, best.foot.squared.hi));
  const bool tied = std::fabs(apart) <= 2 * gap * farther * (1 + 4 * unit_roundoff) + gap * gap;
  const bool wins = beats(challenger, best);
  if (!tied && wins) {
    proper_.rival_count = 0;
    proper_.crowded = false;
  }
  if (tied && !same_feature(challenger, best)) add_rival(wins ? best : challenger);
  if (wins) best = challenger;
}

void Race::add_rival(const Winner& loser) noexcept {
  if (proper_.rival_count == proper_.rivals.size()) {
    proper_.crowded = true;
  } else {
    proper_.rivals[proper_.rival_count++] = loser;
  }
}

bool Race::same_feature(const Winner& a, const Winner& b) const noexcept {
  const auto &ra = triangles_.records[a.slot], &rb = triangles_.records[b.slot];
  const TrianglePlace pa = a.foot.place, pb = b.foot.place;
  if (pa >= 4 && pb >= 4) return ra.vertices[pa - 4] == rb.vertices[pb - 4];
  if (pa >= 1 && pa < 4 && pb >= 1 && pb < 4) return ra.edges[pa - 1] == rb.edges[pb - 1];
  return false;
}

Finding Race::finding() const noexcept {
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
