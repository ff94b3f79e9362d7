#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "soak/changes.h"
#include "soak/families.h"

namespace cdfr::soak {
namespace {

/// Boxes between planes across the axes, each filled or empty.
class Blocks {
 public:
  explicit Blocks(std::array<std::vector<double>, 3> planes)
      : planes_(std::move(planes)), filled_(size(0) * size(1) * size(2), false) {}

  /// Boxes along an axis.
  std::size_t size(std::size_t axis) const { return planes_[axis].size() - 1; }

  /// Beyond the border all is empty.
  bool filled(std::size_t x, std::size_t y, std::size_t z) const {
    return x < size(0) && y < size(1) && z < size(2) && filled_[number(x, y, z)];
  }
  void fill(std::size_t x, std::size_t y, std::size_t z) { filled_[number(x, y, z)] = true; }

  template <class Decide>
  void fill_where(Decide decide) {
    for_each_box([&](std::size_t x, std::size_t y, std::size_t z) {
      if (decide(x, y, z)) fill(x, y, z);
    });
  }

  /// Fills boxes until no two touch in an edge or a corner alone.
  void make_manifold() {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t x = 0; x < size(0); ++x)
        for (std::size_t y = 0; y < size(1); ++y)
          for (std::size_t z = 0; z < size(2); ++z) changed |= mend(x, y, z);
    }
  }

  /// A face between a filled and an empty box is two triangles, cut along a random diagonal.
  Mesh surface(test::Random& random) const {
    Mesh mesh;
    for_each_box([&](std::size_t x, std::size_t y, std::size_t z) {
      if (!filled(x, y, z)) return;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const std::size_t step : {std::size_t{0}, std::size_t{1}}) {
          std::array<std::size_t, 3> other{x, y, z};
          other[axis] = step == 1 ? other[axis] + 1 : other[axis] - 1;  // 0 - 1 is beyond the border too
          if (!filled(other[0], other[1], other[2])) add_face(mesh, {x, y, z}, axis, step, random);
        }
      }
    });
    return mesh;
  }

 private:
  using Place = std::array<std::size_t, 3>;

  std::size_t number(std::size_t x, std::size_t y, std::size_t z) const {
    return (x * size(1) + y) * size(2) + z;
  }

  template <class Visit>
  void for_each_box(Visit visit) const {
    for (std::size_t x = 0; x < size(0); ++x)
      for (std::size_t y = 0; y < size(1); ++y)
        for (std::size_t z = 0; z < size(2); ++z) visit(x, y, z);
  }

  /// Looks at the eight boxes from (x, y, z) on. If the filled ones or the empty ones are not connected
  /// through faces, all are filled.
  bool mend(std::size_t x, std::size_t y, std::size_t z) {
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i)
      mask |= unsigned{filled(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2))} << i;
    if (connected(mask) && connected(~mask & 0xffU)) return false;
    bool changed = false;
    for (unsigned i = 0; i < 8; ++i) {
      const std::size_t a = x + (i & 1), b = y + (i >> 1 & 1), c = z + (i >> 2);
      if (a >= size(0) || b >= size(1) || c >= size(2) || filled(a, b, c)) continue;
      fill(a, b, c);
      changed = true;
    }
    return changed;
  }

  static bool connected(unsigned mask) {
    unsigned reached = mask & (0U - mask);
    for (int round = 0; round < 8; ++round) {
      unsigned next = reached;
      for (unsigned i = 0; i < 8; ++i) {
        if (reached >> i & 1) next |= 1U << (i ^ 1) | 1U << (i ^ 2) | 1U << (i ^ 4);
      }
      reached = next & mask;
    }
    return reached == mask;
  }

  void add_face(Mesh& mesh, const Place& box, std::size_t axis, std::size_t step,
                test::Random& random) const {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
      Place at = box;
      at[axis] += step;
      at[u] += (i == 1 || i == 2) ? 1 : 0;
      at[v] += i >= 2 ? 1 : 0;
      corners[i] = add_vertex(mesh, {planes_[0][at[0]], planes_[1][at[1]], planes_[2][at[2]]});
    }
    if (step == 0) std::swap(corners[1], corners[3]);
    const std::size_t first = random.below(2);
    add_quad(mesh, corners[first], corners[first + 1], corners[(first + 2) % 4], corners[(first + 3) % 4]);
  }

  std::array<std::vector<double>, 3> planes_;
  std::vector<bool> filled_;
};

std::vector<double> random_planes(std::uint64_t boxes, test::Random& random) {
  std::vector<double> planes{0, 1};
  while (planes.size() <= boxes) planes.push_back(random.between(0, 1));
  std::ranges::sort(planes);
  return planes;
}

/// Pairs of planes `width` apart.
std::vector<double> paired_planes(std::uint64_t pairs, double width, test::Random& random) {
  std::vector<double> planes{0, 1};
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const double at = (static_cast<double>(i) + random.between(0.2, 0.7)) / static_cast<double>(pairs);
    planes.push_back(at);
    planes.push_back(at + width);
  }
  std::ranges::sort(planes);
  return planes;
}

std::string text_of(const char* what, std::uint64_t n) { return what + tenth_text(n); }

}  // namespace

Shape make_blocks(std::uint64_t round, test::Random& random) {
  const std::uint64_t count = 1 + strided(round, 0, 6);
  Blocks blocks({random_planes(count, random), random_planes(count, random), random_planes(count, random)});
  const std::uint64_t share = random.below(100);
  blocks.fill_where([&](std::size_t, std::size_t, std::size_t) { return random.below(100) <= share; });
  blocks.fill(0, 0, 0);
  blocks.make_manifold();
  return {std::to_string(count) + " a side", blocks.surface(random)};
}

/// Walls of 1e-6 to 1e-12, or pins where they cross, on a plate.
Shape make_fins(std::uint64_t round, test::Random& random) {
  const std::uint64_t n = strided(round, 6, 12), pairs = 1 + random.below(4);
  Blocks blocks(
      {paired_planes(pairs, tenth(n), random), paired_planes(pairs, tenth(n), random), {0, 0.25, 1}});
  blocks.fill_where([&](std::size_t x, std::size_t y, std::size_t z) {
    const bool wall = round % 3 == 0 ? x % 2 == 1 : (round % 3 == 1 ? x % 2 + y % 2 > 0 : x % 2 + y % 2 == 2);
    return z == 0 || wall;
  });
  return {text_of(round % 3 == 2 ? "pins of " : "walls of ", n), blocks.surface(random)};
}

/// Gaps of 1e-6 to 1e-12: slots in a body, or the space between bodies.
Shape make_slots(std::uint64_t round, test::Random& random) {
  const std::uint64_t n = strided(round, 6, 12), pairs = 1 + random.below(4);
  Blocks blocks(
      {paired_planes(pairs, tenth(n), random), paired_planes(pairs, tenth(n), random), {0, 0.25, 1}});
  blocks.fill_where([&](std::size_t x, std::size_t y, std::size_t z) {
    const bool gap = x % 2 == 1 || (round % 3 != 0 && y % 2 == 1);
    return (z == 0 && round % 2 == 0) || !gap;
  });
  return {text_of(round % 2 == 0 ? "slots of " : "bodies apart by ", n), blocks.surface(random)};
}

/// 1 x 1 x 1e-6, then 1e-7 to 1e-16 and on to 1e-40, its faces cut into coplanar pieces.
Shape make_plate(std::uint64_t round, test::Random& random) {
  const std::uint64_t n = round == 0 ? 6 : (round % 2 == 0 ? strided(round, 7, 16) : strided(round, 17, 40));
  const std::uint64_t count = 1 + random.below(12);
  Blocks blocks({random_planes(count, random), random_planes(count, random), {0, tenth(n)}});
  blocks.fill_where([](std::size_t, std::size_t, std::size_t) { return true; });
  Shape shape{text_of("thickness ", n), blocks.surface(random)};
  return round == 0 || random.below(2) == 0 ? shape : accompanied(std::move(shape), random);
}

}  // namespace cdfr::soak
