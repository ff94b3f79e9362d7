#include "field/contests.h"

#include "field/query.h"
#include "field/race.h"

namespace cdfr {

/// Triangles of no area have rules of their own (Race), and are rare.
void Contests::add(std::size_t place, const Vec3& p, Side side,
                   std::span<const std::uint32_t> slots) noexcept {
  if (used_ + slots.size() > lane_count) settle();
  const auto first = used_;
  for (const std::uint32_t slot : slots) {
    const TriangleShape& shape = field_.triangles.shape(slot);
    if (rounded(shape.normal) == Vec3{}) {
      used_ = first;
      out_[place] = race(p, side, slots);
      return;
    }
    pairs_.set(used_, p, shape);
    slots_[used_++] = slot;
  }
  contests_[contest_count_++] = {place, first, used_ - first, side};
}

void Contests::settle() noexcept {
  if (used_ == 0) return;
  for (std::size_t lane = used_; lane < lane_count; ++lane) pairs_.set(lane, pairs_.p(0), pairs_.triangle(0));
  measure(pairs_, measured_);
  for (std::size_t i = 0; i < contest_count_; ++i) out_[contests_[i].place] = distance_of(contests_[i]);
  contest_count_ = 0;
  used_ = 0;
}

/// Where the leaf knows the side, only the distance is left to find. Else the winner's foot tells the side,
/// and its rivals, if there may be any.
double Contests::distance_of(const Contest& contest) const noexcept {
  const std::uint32_t lane = closest_lane(contest);
  if (const auto told = signed_by_leaf(field_, contest.side, measured_.distance[lane])) return *told;
  const Vec3 p = pairs_.p(lane);
  if (!is_alone(contest, lane)) return race(p, contest.side, {slots_.data() + contest.first, contest.count});
  Finding finding;
  finding.leaf = contest.side;
  finding.winner = {measured_.foot(pairs_.triangle(lane), lane), slots_[lane],
                    field_.triangles.records[slots_[lane]].number};
  return signed_distance(field_, {p, 1}, finding);
}

/// No other one is a rival as Race has it.
bool Contests::is_alone(const Contest& contest, std::uint32_t best) const noexcept {
  const double gap = Race::gap(size_of(field_, pairs_.p(best)));
  for (std::uint32_t lane = contest.first; lane < contest.first + contest.count; ++lane) {
    if (lane != best && Race::tied(squared(lane), squared(best), gap)) return false;
  }
  return true;
}

std::uint32_t Contests::closest_lane(const Contest& contest) const noexcept {
  std::uint32_t best = contest.first;
  for (std::uint32_t lane = best + 1; lane < contest.first + contest.count; ++lane) {
    if (squared(lane) < squared(best)) best = lane;
  }
  return best;
}

double Contests::race(const Vec3& p, Side side, std::span<const std::uint32_t> slots) const noexcept {
  Race race(p, field_.triangles, size_of(field_, p));
  for (const std::uint32_t slot : slots) race.challenge(slot);
  Finding finding = race.finding();
  finding.leaf = side;
  return signed_distance(field_, {p, 1}, finding);
}

}  // namespace cdfr
