#include "contour/regions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "field/leaves.h"
#include "geometry/box_distance.h"

namespace cdfr {
namespace {

class Regions {
 public:
  Regions(const FieldData& field, const Level& level, Progress& progress,
          const std::function<bool(const Region&)>& take)
      : field_(field), level_(level), progress_(progress), take_(take) {}

  RegionCounts run() {
    const std::vector<std::vector<Visited>> visited = visited_leaves();
    double count = 0;
    for (const auto& leaves : visited) count += static_cast<double>(leaves.size());
    progress_.phase(0, 1, count);
    for (const auto& leaves : visited) {
      for (const Visited& leaf : leaves) {
        if (!split({leaf.cube, counts_.visited++, leaf.list, leaf.side})) return counts_;
        progress_.step();
      }
    }
    if (reaches_beyond()) beyond(enclosing());
    return counts_;
  }

 private:
  struct Visited {
    Cube cube;
    std::span<const Entry> list;
    Side side;
  };

  /// Of each block, the leaves that pass. A leaf whose list starts too far away is not even sampled.
  std::vector<std::vector<Visited>> visited_leaves() {
    const std::size_t blocks = field_.tree.block_count();
    std::vector<std::vector<Visited>> visited(blocks);
    std::vector<std::uint64_t> evaluations(blocks);
    for_chunks(blocks, 1, [&](std::size_t i, std::size_t) {
      const Block block = field_.tree.block(i);
      for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
        const Lattice& lattice = field_.tree.lattice;
        const Cube cube{lattice.box(cell).lo, lattice.size(cell.level)};
        const LeafRecord& leaf = block.leaves[number];
        const double least = block.entries[leaf.first].distance() * lattice.edge;
        if (level_.jumps && leaf.side() == level_.other_side()) return;
        if (least > level_.height + level_.reach(cube.half_diagonal()) + level_.rounding || !progress_.poll())
          return;
        ++evaluations[i];
        if (!passes(level_, value_at(field_, level_, cube.centre()), cube)) return;
        visited[i].push_back({cube, {block.entries.data() + leaf.first, leaf.count()}, leaf.side()});
      });
    });
    for (const std::uint64_t n : evaluations) counts_.evaluations += n;
    return visited;
  }

  bool small_enough(const Cube& cube) const noexcept {
    return level_.is_final(std::ldexp(cube.half_diagonal(), -region_depth));
  }

  bool passes_at_centre(const Cube& cube) noexcept {
    ++counts_.evaluations;
    return passes(level_, value_at(field_, level_, cube.centre()), cube);
  }

  /// Precondition: the cube passes.
  bool split(const Region& region) {
    if (!progress_.poll()) return false;
    if (small_enough(region.cube)) return take_(region);
    for (int child = 0; child < 8; ++child) {
      Region part = region;
      part.cube = region.cube.octant(child);
      if (passes_at_centre(part.cube) && !split(part)) return false;
    }
    return true;
  }

  bool reaches_beyond() const noexcept {
    const Box domain = field_.tree.lattice.domain();
    const Box& box = field_.bounds();
    const double beside = level_.rule == Rule::paper ? level_.tolerance / 2 : 0;
    const double reach = level_.side > 0 || level_.jumps ? level_.height + beside + level_.rounding : beside;
    return !contains(domain, {box.lo.x - reach, box.lo.y - reach, box.lo.z - reach}) ||
           !contains(domain, {box.hi.x + reach, box.hi.y + reach, box.hi.z + reach});
  }

  /// The smallest power of two of the lattice's cubes, around the brick, that reaches `height` beyond the
  /// mesh. Its octants fall on the lattice.
  Cube enclosing() const noexcept {
    const Lattice& lattice = field_.tree.lattice;
    const Box& box = field_.bounds();
    const double longest = longest_side(box);
    double size = 16 * lattice.edge;
    while (size < 4 * (level_.height + level_.tolerance + longest)) size *= 2;
    const double before = size / 2 - 4 * lattice.edge;
    return {{lattice.origin.x - before, lattice.origin.y - before, lattice.origin.z - before}, size};
  }

  /// What lies in the brick was left to the leaves; cubes across its border are halved until they are on one
  /// side.
  bool beyond(const Cube& cube) {
    const Box domain = field_.tree.lattice.domain();
    const Vec3 hi{cube.lo.x + cube.size, cube.lo.y + cube.size, cube.lo.z + cube.size};
    if (contains(domain, cube.lo) && contains(domain, hi)) return true;
    if (!passes_at_centre(cube)) return true;
    const bool outside = cube.lo.x >= domain.hi.x || hi.x <= domain.lo.x || cube.lo.y >= domain.hi.y ||
                         hi.y <= domain.lo.y || cube.lo.z >= domain.hi.z || hi.z <= domain.lo.z;
    if (outside) return split({cube, Region::no_leaf, {}, Side::undecided});
    for (int child = 0; child < 8; ++child) {
      if (!beyond(cube.octant(child))) return false;
    }
    return true;
  }

  const FieldData& field_;
  const Level& level_;
  Progress& progress_;
  const std::function<bool(const Region&)>& take_;
  RegionCounts counts_;
};

}  // namespace

RegionCounts for_each_region(const FieldData& field, const Level& level, Progress& progress,
                             const std::function<bool(const Region&)>& take) {
  return Regions(field, level, progress, take).run();
}

}  // namespace cdfr
