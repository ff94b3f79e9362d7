#include "field/grid_query.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "field/contests.h"
#include "field/feature_runs.h"
#include "field/grid_axes.h"
#include "field/query.h"
#include "octree/tile_scan.h"

namespace cdfr {
namespace {

using Sample = std::array<std::uint32_t, 3>;

/// Samples of a chunk along each axis: what one task answers.
constexpr std::uint32_t chunk_side = 32;
/// Samples of a tile along each axis: TilePoints::most of them.
constexpr std::uint32_t tile_side = 4;
/// Fewer samples than this in a leaf are asked one by one: preparing the list would cost more.
constexpr std::size_t fewest = 3;
/// For fewer samples than this, dropping triangles takes longer than asking the samples about them.
constexpr std::size_t fewest_to_prune = 49;

/// Answers the samples of one chunk.
class GridChunk {
 public:
  GridChunk(const FieldData& field, const Grid& grid, const GridAxes& axes, std::span<double> out)
      : field_(field),
        grid_(grid),
        axes_(axes),
        out_(out),
        contests_(field, out),
        runs_(field, out, contests_),
        is_origin_(field.bounds() == Box{}) {
    list_.triangles.reserve(TileList::most + group_size);
    list_.slots.reserve(TileList::most + group_size);
  }

  /// False if cancelled.
  bool answer(const Stretches& chunk, Progress& progress) {
    for (std::uint32_t k = chunk[2].first; k < chunk[2].end; ++k) {
      for (std::uint32_t j = chunk[1].first; j < chunk[1].end; ++j) {
        if (!progress.poll()) return false;
        for (std::uint32_t i = chunk[0].first; i < chunk[0].end;) i = from({i, j, k}, chunk);
      }
    }
    contests_.settle();
    return true;
  }

 private:
  /// Answers a sample, or all of its leaf's samples if it is the first of them. Returns where to go on in its
  /// row.
  std::uint32_t from(const Sample& sample, const Stretches& chunk) {
    if (is_origin_ || !axes_.contains(sample)) {
      singly(sample);
      return sample[0] + 1;
    }
    const std::uint32_t leaf = field_.index.leaf(axes_.place(sample)), up = field_.index.up(leaf);
    Stretches shared;
    bool is_first = true;
    for (int axis = 0; axis < 3 && is_first; ++axis) {
      const std::uint32_t i = sample[axis];
      is_first = i == chunk[axis].first || !axes_.share_cell(axis, i - 1, i, up);
      shared[axis] = {i, axes_.end_of_cell(axis, i, up, chunk[axis].end)};
    }
    if (is_first) in_leaf(shared, field_.index.at(axes_.place(sample), leaf));
    return shared[0].end;
  }

  void in_leaf(const Stretches& samples, const Located& leaf) {
    side_ = leaf.side;
    runs_.begin(side_);
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double lo = axes_.at(axis, samples[axis].first), hi = axes_.at(axis, samples[axis].end - 1);
      middle_[axis] = (lo + hi) / 2;
      squared += (hi - lo) * (hi - lo) / 4;
    }
    if (count_of(samples) < fewest || !list_.fill(field_.triangles, field_.tree.lattice, leaf.entries,
                                                  {middle_[0], middle_[1], middle_[2]}, std::sqrt(squared))) {
      return all_singly(samples);
    }
    std::array<std::uint16_t, TileList::most> numbers;
    const std::size_t count = list_.triangles.size();
    for (std::size_t n = 0; n < count; ++n) numbers[n] = static_cast<std::uint16_t>(n);
    divide(samples, {numbers.data(), count});
    runs_.settle();
  }

  /// Halves each axis that is longer than a tile.
  void divide(const Stretches& samples, TileNumbers numbers) {
    const auto half = [](const Stretch& s) {
      if (s.size() <= tile_side) return s.end;
      return s.first + (s.size() / 2 + tile_side - 1) / tile_side * tile_side;
    };
    for (int part = 0; part < 8; ++part) {
      Stretches smaller = samples;
      for (int axis = 0; axis < 3; ++axis) {
        (part >> axis & 1 ? smaller[axis].first : smaller[axis].end) = half(samples[axis]);
      }
      if (count_of(smaller) != 0) prune_in(smaller, numbers);
    }
  }

  void prune_in(const Stretches& samples, TileNumbers numbers) {
    std::array<std::uint16_t, TileList::most> kept;
    std::size_t count = numbers.size();
    const bool is_tile =
        std::all_of(samples.begin(), samples.end(), [](const Stretch& s) { return s.size() <= tile_side; });
    if (count > 2 && count_of(samples) >= fewest_to_prune) {
      count = prune(list_, numbers, box(samples), kept.data());
      numbers = {kept.data(), count};
    }
    if (!is_tile) return divide(samples, numbers);
    tile(samples, numbers);
  }

  float coordinate(int axis, std::uint32_t i) const {
    return static_cast<float>(axes_.at(axis, i) - middle_[axis]);
  }

  TileBox box(const Stretches& samples) const {
    TileBox box;
    for (int axis = 0; axis < 3; ++axis) {
      const float first = coordinate(axis, samples[axis].first),
                  last = coordinate(axis, samples[axis].end - 1);
      box.lo[axis] = std::min(first, last);
      box.hi[axis] = std::max(first, last);
    }
    return box;
  }

  void tile(const Stretches& samples, TileNumbers numbers) {
    TilePoints points{};
    for_samples(samples, [&](const Sample& sample) {
      for (int axis = 0; axis < 3; ++axis) points.at[axis][points.count] = coordinate(axis, sample[axis]);
      ++points.count;
    });
    TileFindings found;
    if (!scan_tile(list_, numbers, points, found)) return all_singly(samples);
    std::size_t point = 0;
    for_samples(samples, [&](const Sample& sample) {
      const auto foot = static_cast<TrianglePlace>(found.place[point]);
      if (foot == unsure_place) {
        contest(sample, found, found.kept[point]);
      } else {
        const auto number = static_cast<std::size_t>(found.number[point]);
        runs_.add(place(sample), axes_.point(sample), list_.slots[number], number, foot);
      }
      ++point;
    });
  }

  void contest(const Sample& sample, const TileFindings& found, std::uint64_t kept) {
    std::array<std::uint32_t, Contests::most> slots;
    std::size_t count = 0;
    for (; kept != 0; kept &= kept - 1) {
      if (count == slots.size()) return singly(sample);
      slots[count++] = list_.slots[found.survivors[static_cast<std::size_t>(std::countr_zero(kept))]];
    }
    contests_.add(place(sample), axes_.point(sample), side_, {slots.data(), count});
  }

  template <class Visit>
  static void for_samples(const Stretches& s, Visit visit) {
    for (std::uint32_t k = s[2].first; k < s[2].end; ++k) {
      for (std::uint32_t j = s[1].first; j < s[1].end; ++j) {
        for (std::uint32_t i = s[0].first; i < s[0].end; ++i) visit(Sample{i, j, k});
      }
    }
  }

  std::size_t place(const Sample& s) const {
    return (std::size_t{s[2]} * grid_.size[1] + s[1]) * grid_.size[0] + s[0];
  }
  void singly(const Sample& s) { out_[place(s)] = signed_distance(field_, grid_.point(s[0], s[1], s[2])); }
  void all_singly(const Stretches& samples) {
    for_samples(samples, [&](const Sample& sample) { singly(sample); });
  }

  const FieldData& field_;
  const Grid& grid_;
  const GridAxes& axes_;
  std::span<double> out_;
  TileList list_;
  Contests contests_;
  FeatureRuns runs_;
  std::array<double, 3> middle_{};  ///< of the leaf's samples, in edges
  Side side_ = Side::undecided;
  const bool is_origin_;  ///< the mesh: queries may have to be scaled
};

/// Chunks of a grid, numbered with x fastest.
struct Chunks {
  explicit Chunks(const Grid& grid) : size(grid.size) {
    for (int axis = 0; axis < 3; ++axis)
      across[axis] = (std::size_t{size[axis]} + chunk_side - 1) / chunk_side;
  }
  std::size_t count() const { return across[0] * across[1] * across[2]; }
  Stretches at(std::size_t number) const {
    const std::size_t place[3] = {number % across[0], number / across[0] % across[1],
                                  number / across[0] / across[1]};
    Stretches samples;
    for (int axis = 0; axis < 3; ++axis) {
      const auto first = static_cast<std::uint32_t>(place[axis] * chunk_side);
      samples[axis] = {first, first + std::min(chunk_side, size[axis] - first)};
    }
    return samples;
  }
  std::array<std::uint32_t, 3> size;
  std::array<std::size_t, 3> across;
};

}  // namespace

Result<void> grid_distances(const FieldData& field, const Grid& grid, std::span<double> out, const Run& run) {
  if (out.empty()) return {};
  const FloatingEnvironment environment;
  const GridAxes axes(grid, field.index);
  const Chunks chunks(grid);
  Progress progress(run);
  progress.phase(0, 1, static_cast<double>(chunks.count()));
  with_threads(run, [&] {
    for_chunks(chunks.count(), 1, [&](std::size_t number, std::size_t) {
      const FloatingEnvironment of_worker;
      if (progress.cancelled()) return;
      if (GridChunk(field, grid, axes, out).answer(chunks.at(number), progress)) progress.step();
    });
  });
  if (progress.cancelled()) return Progress::error();
  return {};
}

}  // namespace cdfr
