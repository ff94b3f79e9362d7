#include "soak/box_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace cdfr::soak {
namespace {

constexpr std::uint32_t leaf_size = 4;

Box united(const Box& a, const Box& b) noexcept {
  return {{std::min(a.lo.x, b.lo.x), std::min(a.lo.y, b.lo.y), std::min(a.lo.z, b.lo.z)},
          {std::max(a.hi.x, b.hi.x), std::max(a.hi.y, b.hi.y), std::max(a.hi.z, b.hi.z)}};
}

double middle(const Box& box, int axis) noexcept {
  const std::array lo{box.lo.x, box.lo.y, box.lo.z}, hi{box.hi.x, box.hi.y, box.hi.z};
  return lo[static_cast<std::size_t>(axis)] / 2 + hi[static_cast<std::size_t>(axis)] / 2;
}

int longest_axis(const Box& box) noexcept {
  const double x = box.hi.x - box.lo.x, y = box.hi.y - box.lo.y, z = box.hi.z - box.lo.z;
  if (x >= y && x >= z) return 0;
  return y >= z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (boxes_.empty()) return;
  nodes_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(boxes_.size()));
}

void BoxTree::split(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  Box box = boxes_[order_[first]];
  for (std::uint32_t i = first; i < first + count; ++i) box = united(box, boxes_[order_[i]]);
  nodes_[node] = {box, first, count};
  if (count <= leaf_size) return;
  const int axis = longest_axis(box);
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    const double x = middle(boxes_[a], axis), y = middle(boxes_[b], axis);
    return x != y ? x < y : a < b;
  });
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node] = {box, child, 0};
  split(child, first, count / 2);
  split(child + 1, first + count / 2, count - count / 2);
}

}  // namespace cdfr::soak
