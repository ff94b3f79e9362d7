#include "contour/surface_leaves.h"

#include "core/parallel.h"
#include "core/vector.h"
#include "field/distance_above.h"

namespace cdfr {
namespace {

constexpr std::size_t leaves_a_task = 64;

constexpr std::array<SignCase, 256> make_cases() {
  std::array<SignCase, 256> cases{};
  for (unsigned held = 0; held < 256; ++held) cases[held] = sign_case(held);
  return cases;
}
const std::array<SignCase, 256> cases = make_cases();

}  // namespace

SurfaceLeaves::SurfaceLeaves(const Sought& sought, const SurfaceLattice& lattice)
    : sought_(sought), octree_(sought, lattice), corners_(sought, octree_.lattice()) {}

bool SurfaceLeaves::descend(Progress& progress) { return settle(octree_.descend(progress), progress); }

bool SurfaceLeaves::split(std::span<const std::uint32_t> leaves, Progress& progress) {
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t number : leaves) {
    leaves_[number].live = false;
    cells.push_back(leaves_[number].cell);
  }
  return settle(octree_.split(cells, progress), progress);
}

void SurfaceLeaves::add(std::uint32_t number) {
  SurfaceCell& cell = octree_.cell(number);
  cell.leaf = static_cast<std::uint32_t>(leaves_.size());
  SurfaceLeaf leaf;
  leaf.cell = number;
  leaf.sides.fill(no_index);
  const std::uint32_t width = octree_.lattice().width(cell.level);
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    GridPlace place = cell.lo;
    for (std::size_t axis = 0; axis < 3; ++axis) place[axis] += (corner >> axis & 1U) * width;
    leaf.corners[corner] = corners_.number(place);
  }
  leaves_.push_back(leaf);
}

bool SurfaceLeaves::settle(std::vector<std::uint32_t> cells, Progress& progress) {
  while (!cells.empty() && !progress.cancelled()) {
    const std::size_t first_leaf = leaves_.size();
    for (const std::uint32_t cell : cells) add(cell);
    if (!corners_.evaluate(progress)) return false;
    std::vector<Verdict> verdicts(cells.size());
    for_chunks(cells.size(), leaves_a_task, [&](std::size_t first, std::size_t end) {
      if (!progress.poll()) return;
      std::vector<NearTriangle> near;
      for (std::size_t i = first; i < end; ++i) {
        SurfaceLeaf& leaf = leaves_[first_leaf + i];
        for (std::size_t k = 0; k < 8; ++k)
          leaf.held = static_cast<std::uint8_t>(leaf.held | corners_.held(leaf.corners[k]) << k);
        verdicts[i] = judge(leaf, near);
      }
    });
    if (progress.cancelled()) return false;
    std::vector<std::uint32_t> again;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      SurfaceLeaf& leaf = leaves_[first_leaf + i];
      leaf.undecided = verdicts[i] == Verdict::undecided;
      leaf.live = verdicts[i] == Verdict::keep || leaf.undecided;
      if (verdicts[i] == Verdict::empty) {
        octree_.cell(leaf.cell).state = CellState::empty;
        octree_.cell(leaf.cell).busy = false;
      }
      if (verdicts[i] == Verdict::split) again.push_back(leaf.cell);
    }
    cells = octree_.split(again, progress);
  }
  return !progress.cancelled() && !octree_.overflowed();
}

SurfaceLeaves::Verdict SurfaceLeaves::judge(const SurfaceLeaf& leaf, std::vector<NearTriangle>& near) const {
  const int level = octree_.cell(leaf.cell).level;
  if (leaf.held == 0 || leaf.held == 0xff) return judge_hidden(leaf, near);
  const SignCase& at = cases[leaf.held];
  const bool simple = at.loops == 1 && !at.ambiguous;
  return simple || level == octree_.lattice().deepest ? Verdict::keep : Verdict::split;
}

/// All corners have one sign: is there proof that the contour stays out, or nearly?
SurfaceLeaves::Verdict SurfaceLeaves::judge_hidden(const SurfaceLeaf& leaf,
                                                   std::vector<NearTriangle>& near) const {
  const SurfaceCell& cell = octree_.cell(leaf.cell);
  // Within the slack of one plane it may bulge in through a face by twice the slack, and the cell behind that
  // face has it.
  if (cell.planes == 1) return Verdict::keep;
  const SurfaceLattice& lattice = octree_.lattice();
  const double size = lattice.size(cell.level), height = sought_.height();
  const Eigen::Vector3d centre = to_eigen(lattice.centre(cell.lo, cell.level));
  const bool high = sought_.is_high(corners_[leaf.corners[0]]);
  if (sought_.distance == 0) return Verdict::keep;
  if (octree_.near(cell, near) && !near.empty()) {
    const Flatness bounds = distance_bounds(sought_.field, centre, size, near);
    if (high ? bounds.least > height + sought_.rounding : bounds.most < height - sought_.rounding)
      return Verdict::empty;
    if (high && bounds.least >= height - 2 * sought_.slack.above) return Verdict::keep;
    // What reaches above the height by less than half the deepest cells' edge no corner needs to show.
    if (!high && 2 * (bounds.most - height) < lattice.step) return Verdict::undecided;
    if (flatness(sought_.field, centre, size, sought_.slack, near).planes == 1) return Verdict::keep;
  } else if (!high &&
             distance_above(sought_.field, lattice.corner(cell.lo), size) < height - sought_.rounding) {
    return Verdict::empty;
  }
  return cell.level < lattice.deepest ? Verdict::split : Verdict::undecided;
}

}  // namespace cdfr
