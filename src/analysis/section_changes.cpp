#include "cdfr/analysis/section_changes.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_distance.h"

namespace cdfr {
namespace {

struct Pair {
  double apart;
  std::size_t now, former;
};

Box grown(const Box& box, double by) noexcept {
  return {{box.lo.x - by, box.lo.y - by, box.lo.z - by}, {box.hi.x + by, box.hi.y + by, box.hi.z + by}};
}

SectionFate fate_of(const Section& now, const Section& former) noexcept {
  const double volume = now.volume - former.volume, radius = now.ball.radius - former.ball.radius;
  if (std::fabs(volume) > now.volume_error + former.volume_error)
    return volume > 0 ? SectionFate::grown : SectionFate::shrunk;
  if (std::fabs(radius) > now.ball.error + former.ball.error)
    return radius > 0 ? SectionFate::grown : SectionFate::shrunk;
  return SectionFate::same;
}

std::vector<Pair> possible_pairs(const Sections& now, const Sections& former) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < now.sections.size(); ++i) {
    const Section& own = now.sections[i];
    const Box box = grown(own.box, now.error + former.error);
    for (std::size_t j = 0; j < former.sections.size(); ++j) {
      const Section& other = former.sections[j];
      if (overlap(box, other.box))
        pairs.push_back({distance_between(own.ball.centre, other.ball.centre), i, j});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.apart < b.apart; });
  return pairs;
}

}  // namespace

std::vector<SectionChange> section_changes(const Sections& now, const Sections& former) {
  std::vector<SectionChange> changes;
  for (std::size_t i = 0; i < now.sections.size(); ++i)
    changes.push_back({SectionFate::added, i, std::nullopt});
  std::vector<bool> matched(former.sections.size());
  for (const Pair& pair : possible_pairs(now, former)) {
    SectionChange& change = changes[pair.now];
    if (change.former || matched[pair.former]) continue;
    matched[pair.former] = true;
    change = {fate_of(now.sections[pair.now], former.sections[pair.former]), pair.now, pair.former};
  }
  for (std::size_t j = 0; j < matched.size(); ++j) {
    if (!matched[j]) changes.push_back({SectionFate::gone, std::nullopt, j});
  }
  return changes;
}

}  // namespace cdfr
