#include <array>

#include "analysis/ascent.h"
#include "analysis/depth_tree.h"
#include "core/parallel.h"
#include "field/query.h"

namespace cdfr {
namespace {

constexpr std::size_t none = CriticalCells::none;
constexpr std::size_t cells_a_chunk = 64;
/// The depth has slope 1 at most, so where it falls by so much of a step the way up leads straight back.
constexpr double straight_down = 0.9;

class Linker {
 public:
  Linker(const FieldData& field, const CriticalCells& critical, double floor, Progress& progress)
      : field_(field), critical_(critical), floor_(floor), progress_(progress), ascent_(field) {}

  void run(std::size_t number) {
    const Cell cell = cell_of(critical_.cells[number].key);
    for (int step = 0; step < 27; ++step) {
      Cell beside = cell;
      bool is_there = step != 13;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int way = std::array{step % 3, step / 3 % 3, step / 9}[axis] - 1;
        beside.place[axis] = cell.place[axis] + static_cast<std::uint32_t>(way);
        is_there = is_there && beside.place[axis] < field_.tree.lattice.bricks[axis] << cell.level;
      }
      if (is_there) touch(number, beside);
    }
    for (int side = 0; side < 6; ++side) climb_from(number, side);
  }
  std::vector<DepthLink> links;

 private:
  /// A smaller cell looks for larger ones, and a first one for those of its size: each pair comes up once.
  void touch(std::size_t number, const Cell& beside) {
    const std::size_t other = critical_.find(beside);
    if (other == none) return;
    const int level = cell_of(critical_.cells[other].key).level;
    if (level < beside.level || (level == beside.level && number < other)) join(number, other);
  }

  void join(std::size_t a, std::size_t b) {
    const CriticalCell &from = critical_.cells[a], &to = critical_.cells[b];
    const double depth = way_depth(from.core, from.depth, to.core, to.depth);
    if (depth > floor_) links.push_back({a, b, depth, from.depth < to.depth ? from.core : to.core});
  }

  /// From beside the core, where there is no critical cell.
  void climb_from(std::size_t number, int side) {
    const CriticalCell& cell = critical_.cells[number];
    const Cell own = cell_of(cell.key);
    const double size = field_.tree.lattice.size(own.level), step = side % 2 == 0 ? size : -size;
    Cell beside = own;
    Vec3 start = cell.core;
    (side / 2 == 0 ? start.x : side / 2 == 1 ? start.y : start.z) += step;
    beside.place[static_cast<std::size_t>(side / 2)] += side % 2 == 0 ? 1U : ~0U;
    if (critical_.find(beside) != none) return;
    const double depth = -signed_distance(field_, start);
    if (!(depth > floor_) || cell.depth - depth >= straight_down * size) return;
    const std::size_t top = ascent_.climb(critical_, start, depth, progress_);
    if (top == none || top == number) return;
    const double way = std::min(way_depth(cell.core, cell.depth, start, depth), critical_.cells[top].depth);
    if (way > floor_) links.push_back({number, top, way, depth < cell.depth ? start : cell.core});
  }

  const FieldData& field_;
  const CriticalCells& critical_;
  double floor_;
  Progress& progress_;
  Ascent ascent_;
};

}  // namespace

std::vector<DepthLink> depth_links(const FieldData& field, const CriticalCells& critical, double floor,
                                   Progress& progress) {
  const std::size_t count = critical.cells.size();
  std::vector<std::vector<DepthLink>> found((count + cells_a_chunk - 1) / cells_a_chunk);
  progress.phase(0.5, 0.8, static_cast<double>(found.size()));
  for_chunks(count, cells_a_chunk, [&](std::size_t first, std::size_t end) {
    Linker linker(field, critical, floor, progress);
    for (std::size_t i = first; i < end && progress.poll(); ++i) linker.run(i);
    found[first / cells_a_chunk] = std::move(linker.links);
    progress.step();
  });
  std::vector<DepthLink> links;
  for (const std::vector<DepthLink>& part : found) links.insert(links.end(), part.begin(), part.end());
  return links;
}

}  // namespace cdfr
