/// The 26-neighbour wavefront of papers/huang-2001, section 3.4.
///
/// In each round every voxel looks at the triangles that came to a neighbour in the round before, measures
/// those that it does not have, and keeps the range [m, m + sqrt(3) s] of old and new. It ends when no list
/// changes; as m only falls, what was dropped never comes back, so it does end. Rounds are synchronous: the
/// result depends on no order.
///
/// What it brings. Let T be closest to an inner point P of a kept voxel, q its closest point of T. T stays
/// closest all along the segment from P to q, which has inner points alone, so no voxel on the way was
/// flooded; the voxel of q is touched by T, and each voxel on the way has T in its range from its first round
/// on. So T arrives. What it may miss are tuples that are in a voxel's range and closest nowhere in it, and
/// those closest to an *outer* point of a surface voxel whose segment leads through voxels that were dropped.
#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

#include "core/parallel.h"
#include "reference/uniform_data.h"

namespace cdfr {
namespace {

using Numbers = std::vector<std::uint32_t>;

constexpr std::size_t cells_a_task = 64;

class Propagation {
 public:
  Propagation(UniformData& data, Progress& progress)
      : data_(data), progress_(progress), fresh_(data.lists.size()), is_target_(data.lists.size(), 0) {}

  Result<void> run() {
    std::vector<std::size_t> frontier;
    for (std::size_t cell = 0; cell < data_.lists.size(); ++cell) {
      for (const CddTuple& tuple : data_.lists[cell]) fresh_[cell].push_back(tuple.triangle);
      std::ranges::sort(fresh_[cell]);
      tuples_ += data_.lists[cell].size();
      if (!data_.lists[cell].empty()) frontier.push_back(cell);
    }
    const auto longest = static_cast<double>(*std::ranges::max_element(data_.grid.counts));
    progress_.phase(0.1, 1, longest);
    for (; !frontier.empty(); ++data_.rounds) {
      if (Result<void> fits = expect_few_enough(tuples_); !fits) return fits;
      frontier = advance(frontier);
      if (progress_.cancelled()) return Progress::error();
      if (static_cast<double>(data_.rounds) < longest) progress_.step();
    }
    data_.measured = measured_;
    return {};
  }

 private:
  /// One round; returns the voxels whose lists took something in.
  std::vector<std::size_t> advance(const std::vector<std::size_t>& frontier) {
    const std::vector<std::size_t> targets = neighbours_of(frontier);
    std::vector<Numbers> taken(targets.size());
    for_chunks(targets.size(), cells_a_task, [&](std::size_t first, std::size_t end) {
      if (!progress_.poll()) return;
      for (std::size_t i = first; i < end; ++i) taken[i] = inherit(targets[i]);
    });
    for (const std::size_t cell : frontier) Numbers().swap(fresh_[cell]);
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (taken[i].empty()) continue;
      fresh_[targets[i]] = std::move(taken[i]);
      changed.push_back(targets[i]);
    }
    return changed;
  }

  bool takes_part(std::size_t cell) const noexcept {
    if (data_.sides[cell] == Side::outside) return data_.options.keep_outside;
    return data_.sides[cell] == Side::inside || data_.options.surface_inherits;
  }

  std::vector<std::size_t> neighbours_of(const std::vector<std::size_t>& frontier) {
    std::vector<std::size_t> targets;
    for (const std::size_t cell : frontier) {
      data_.grid.for_each_neighbour(cell, [&](std::size_t other) {
        if (is_target_[other] != 0 || !takes_part(other)) return;
        is_target_[other] = 1;
        targets.push_back(other);
      });
    }
    for (const std::size_t cell : targets) is_target_[cell] = 0;
    return targets;
  }

  /// Triangles that are new with a neighbour and not in the voxel's own list, ascending.
  Numbers offered(std::size_t cell) const {
    Numbers found, own;
    data_.grid.for_each_neighbour(cell, [&](std::size_t other) {
      found.insert(found.end(), fresh_[other].begin(), fresh_[other].end());
    });
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const CddTuple& tuple : data_.lists[cell]) own.push_back(tuple.triangle);
    std::ranges::sort(own);
    Numbers unknown;
    std::ranges::set_difference(found, own, std::back_inserter(unknown));
    return unknown;
  }

  /// Returns what the voxel's list took in and kept.
  Numbers inherit(std::size_t cell) {
    const Numbers offer = offered(cell);
    if (offer.empty()) return {};
    std::vector<CddTuple>& list = data_.lists[cell];
    const std::size_t before = list.size();
    const Vec3 centre = data_.grid.centre(data_.grid.place(cell));
    for (const std::uint32_t t : offer) list.push_back(cdd_tuple(data_.surface, centre, t));
    std::ranges::sort(list, {}, [](const CddTuple& a) { return std::pair(a.distance, a.triangle); });
    const double most =
        list.front().distance + 2 * half_diagonal_of_unit * data_.grid.size + 2 * data_.grid.slack;
    std::erase_if(list, [&](const CddTuple& tuple) { return tuple.distance > most; });
    measured_ += offer.size();
    tuples_ += list.size() - before;
    Numbers kept;
    for (const CddTuple& tuple : list) {
      if (std::ranges::binary_search(offer, tuple.triangle)) kept.push_back(tuple.triangle);
    }
    std::ranges::sort(kept);
    return kept;
  }

  UniformData& data_;
  Progress& progress_;
  std::vector<Numbers> fresh_;  ///< by cell: triangles that its list took in in the last round, ascending
  std::vector<std::uint8_t> is_target_;
  std::atomic<std::uint64_t> tuples_{0}, measured_{0};
};

}  // namespace

Result<void> propagate(UniformData& data, Progress& progress) { return Propagation(data, progress).run(); }

}  // namespace cdfr
