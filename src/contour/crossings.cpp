#include "contour/crossings.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/parallel.h"
#include "field/batch.h"

namespace cdfr {
namespace {

constexpr std::size_t crossings_a_task = 256;
/// A crossing is good if its distance is off by this share of the tolerance; halving has come far below it
/// after so many rounds, for deepest cells are no larger than the tolerance.
constexpr double good_share = 1.0 / 128;
constexpr int most_rounds = 40;

double coordinate(const Vec3& v, int axis) noexcept { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
double& coordinate(Vec3& v, int axis) noexcept { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Where the line through two values of opposite sign is zero.
double on_line(double from, double to, double at_from, double at_to) noexcept {
  return from + (to - from) * (at_from / (at_from - at_to));
}

}  // namespace

std::uint32_t Crossings::add(int axis, std::uint32_t low, std::uint32_t high) {
  edges_.push_back({axis, low, high});
  return static_cast<std::uint32_t>(edges_.size() - 1);
}

bool Crossings::lies_in(std::uint32_t part, std::uint32_t whole) const noexcept {
  const Edge &small = edges_[part], &large = edges_[whole];
  const auto at = [&](std::uint32_t corner) { return coordinate(corners_.position(corner), small.axis); };
  return small.axis == large.axis && at(small.low) >= at(large.low) && at(small.high) <= at(large.high);
}

/// Rounding may not bring it to an end: the hair is above 2^-20 of 2^22 doubles (fits()).
Vec3 Crossings::place(const Edge& edge, double share) const noexcept {
  Vec3 position = corners_.position(edge.low);
  double& along = coordinate(position, edge.axis);
  const double length = coordinate(corners_.position(edge.high), edge.axis) - along;
  along += length * std::clamp(share, hair_share, 1 - hair_share);
  return position;
}

bool Crossings::solve(Progress& progress) {
  const std::size_t done = crossings_.size();
  crossings_.resize(edges_.size());
  std::vector<std::vector<Bracket>> tasks((edges_.size() - done + crossings_a_task - 1) / crossings_a_task);
  std::vector<std::uint64_t> evaluations(tasks.size());
  for_chunks(edges_.size() - done, crossings_a_task, [&](std::size_t first, std::size_t end) {
    std::vector<Bracket> open;
    for (std::size_t i = done + first; i < done + end; ++i) {
      Bracket bracket{static_cast<std::uint32_t>(i)};
      bracket.at_from = corners_[edges_[i].low] - sought_.distance;
      bracket.at_to = corners_[edges_[i].high] - sought_.distance;
      bracket.share = on_line(0, 1, bracket.at_from, bracket.at_to);
      open.push_back(bracket);
    }
    std::vector<Vec3> places;
    std::vector<Closest> answers;
    for (int round = 0; !open.empty() && round < most_rounds; ++round) {
      places.clear();
      for (const Bracket& b : open) places.push_back(place(edges_[b.number], b.share));
      answers.resize(open.size());
      if (!progress.poll() ||
          !answer(sought_.field, std::span<const Vec3>(places), 0, std::span(answers), progress))
        return;
      evaluations[first / crossings_a_task] += open.size();
      std::size_t kept = 0;
      for (std::size_t i = 0; i < open.size(); ++i) {
        crossings_[open[i].number] = {places[i], answers[i].gradient, answers[i].distance - sought_.distance};
        if (!improve(open[i], answers[i], round)) open[kept++] = open[i];
      }
      open.resize(kept);
    }
  });
  for (const std::uint64_t n : evaluations) evaluations_ += n;
  return !progress.cancelled();
}

/// True if it is good. A tangent that leaves the bracket, or does not shorten it quickly, gives way to the
/// middle.
bool Crossings::improve(Bracket& bracket, const Closest& closest, int round) noexcept {
  const double excess = closest.distance - sought_.distance;
  if (std::fabs(excess) <= good_share * sought_.tolerance) return true;
  const Edge& edge = edges_[bracket.number];
  const double length = coordinate(corners_.position(edge.high), edge.axis) -
                        coordinate(corners_.position(edge.low), edge.axis);
  if ((excess < 0) == (bracket.at_from < 0)) {
    bracket.from = bracket.share;
    bracket.at_from = excess;
  } else {
    bracket.to = bracket.share;
    bracket.at_to = excess;
  }
  const double slope = coordinate(closest.gradient, edge.axis) * length;
  const double tangent = bracket.share - excess / slope;
  const bool use_tangent = round % 3 != 2 && tangent > bracket.from && tangent < bracket.to;
  bracket.share = use_tangent ? tangent : (bracket.from + bracket.to) / 2;
  return false;
}

}  // namespace cdfr
