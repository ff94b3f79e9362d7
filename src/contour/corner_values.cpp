#include "contour/corner_values.h"

#include <span>

#include "core/parallel.h"
#include "field/batch.h"

namespace cdfr {
namespace {

constexpr std::size_t corners_a_task = 512;

}  // namespace

std::uint32_t CornerValues::number(const GridPlace& place) {
  const std::uint64_t key = place[0] | std::uint64_t{place[1]} << 21 | std::uint64_t{place[2]} << 42;
  const auto [number, is_new] = numbering_.number(key);
  if (is_new) positions_.push_back(lattice_.corner(place));
  return number;
}

bool CornerValues::evaluate(Progress& progress) {
  const std::size_t done = values_.size();
  values_.resize(positions_.size());
  const std::span<const Vec3> all(positions_);
  for_chunks(values_.size() - done, corners_a_task, [&](std::size_t first, std::size_t end) {
    if (!progress.poll()) return;
    answer(sought_.field, all, done + first, std::span(values_).subspan(done + first, end - first), progress);
  });
  return !progress.cancelled();
}

}  // namespace cdfr
