// Options that multiply cells until the machine is out of memory, and batches that need memory for every
// point.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <span>
#include <vector>

#include "cdfr/contour/contour.h"
#include "cdfr/field/field.h"
#include "faults/star.h"
#include "oracle/point_count.h"
#include "support/meshes.h"

namespace {

/// Bytes that this program asked for, in all threads.
std::atomic<std::size_t> asked_for = 0;

void* counted(std::size_t size) noexcept {
  asked_for += size;
  return std::malloc(size == 0 ? 1 : size);
}

void* taken(std::size_t size) {
  if (void* memory = counted(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return taken(size); }
void* operator new[](std::size_t size) { return taken(size); }
// std::stable_sort asks for its buffer this way; all forms have to fit the deletes below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace cdfr {
namespace {

/// What no field of so small a mesh may exceed, at any depth: 2 MiB and 64 KiB a triangle.
std::uint64_t bound_of(const Mesh& mesh) {
  return (2U << 20) + (std::uint64_t{64} << 10) * mesh.triangles.size();
}

/// One level after another, so that an octree without bounds fails here before it takes the machine's memory;
/// in light runs every seventh.
void expect_bounded(const Mesh& mesh) {
  std::uint64_t last = 0;
  for (int level = 4; level <= 18; level += oracle::light_run() ? 7 : 1) {
    BuildOptions options;
    options.max_triangles_per_leaf = 1;
    options.max_level = level;
    const Stats stats = Field::build(mesh.view(), options).value().stats();
    ASSERT_LE(stats.bytes, bound_of(mesh))
        << mesh.triangles.size() << " triangles, level " << level << ", before it " << last;
    last = stats.bytes;
    if (stats.levels.size() <= static_cast<std::size_t>(level)) break;  // more levels change nothing
  }
}

TEST(MemoryExhausted, ByDepthOverACube) { expect_bounded(test::box_mesh({{0, 0, 0}, {1, 1, 1}})); }

TEST(MemoryExhausted, ByDepthOverACubeOffTheGrid) {
  expect_bounded(test::box_mesh({{0.1, 0.2, 0.3}, {1, 1.3, 1.7}}));
}

TEST(MemoryExhausted, ByDepthOverATetrahedron) { expect_bounded(test::flat_tetrahedron()); }

TEST(MemoryExhausted, ByDepthOverTrianglesThatShareAPoint) { expect_bounded(test::many_fans(24)); }

TEST(MemoryExhausted, ByDepthAtTheCentreOfASphere) { expect_bounded(test::sphere_mesh(1)); }

TEST(MemoryExhausted, ByDepthOverEqualTriangles) {
  Mesh heap;
  heap.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  heap.triangles.assign(500, {0, 1, 2});
  expect_bounded(heap);
  heap.vertices = {{3, 4, 5}};
  heap.triangles.assign(500, {0, 0, 0});
  expect_bounded(heap);
}

/// The defaults, on a mesh of any kind, triangles that cross each other included.
TEST(MemoryExhausted, NotByTheDefaults) {
  for (const Mesh& mesh : {test::sphere_mesh(4), test::spiky_star(4, 1), test::many_fans(400),
                           test::soup(1000, {{0, 0, 0}, {1, 1, 1}}, 2)}) {
    const Stats stats = Field::build(mesh.view()).value().stats();
    EXPECT_LE(stats.bytes, (2U << 20) + 8192 * stats.triangles);
  }
}

struct Patience {
  int left;
  static bool tick(void* context, double) noexcept { return --static_cast<Patience*>(context)->left > 0; }
};

/// Every split kept, to the last level: no machine holds that, but the caller stays in control.
TEST(MemoryExhausted, ARunawayBuildCanBeStopped) {
  BuildOptions options;
  options.max_triangles_per_leaf = 1;
  options.max_level = 18;
  options.gain = 1;
  Patience patience{20};
  const Result<Field> field =
      Field::build(test::spiky_star(2, 3).view(), options, {1, &Patience::tick, &patience});
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().code, Code::cancelled);
}

TEST(MemoryExhausted, NotByQueries) {
  const Field field = Field::build(test::sphere_mesh(3).view()).value();
  test::Random random(4);
  double sum = 0;
  const std::size_t before = asked_for;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = i % 10 == 0 ? Vec3{} : random.in({{-3, -3, -3}, {3, 3, 3}});
    sum += field.distance(p) + field.closest(p).distance;
  }
  EXPECT_EQ(asked_for - before, 0U);
  EXPECT_GT(sum, 0);
}

/// A small batch needs its in- and output and no more. A large one has an order too, of 12 bytes a point and
/// of four million points at a time, and in all of its tasks together copies each point and answer once. x
/// may lie in rows of the caller's own.
TEST(MemoryExhausted, NotByBatches) {
  const Field field = Field::build(test::sphere_mesh(2).view()).value();
  constexpr std::size_t stride = 5;
  for (const std::size_t count : {1000U, 300000U}) {
    std::vector<double> rows(count * stride);
    test::Random random(5);
    for (double& x : rows) x = random.between(-2, 2);
    std::vector<double> out(count);
    ASSERT_TRUE(field.distance(Points(rows.data(), count, stride), out));  // workers come up once
    const std::size_t before = asked_for;
    ASSERT_TRUE(field.distance(Points(rows.data(), count, stride), out));
    const std::size_t ordered = count < 16384 ? 0 : count * (12 + sizeof(Vec3) + sizeof(double));
    EXPECT_LE(asked_for - before, (std::size_t{64} << 10) + ordered) << count;
    EXPECT_EQ(out[count - 1], field.distance(Points(rows.data(), count, stride)[count - 1]));
  }
}

class BlockLengths : public PointSink {
 public:
  Result<void> write(std::span<const ContourPoint> points) override {
    longest_ = std::max(longest_, points.size());
    total_ += points.size();
    return {};
  }
  std::size_t longest() const { return longest_; }
  std::size_t total() const { return total_; }

 private:
  std::size_t longest_ = 0, total_ = 0;
};

/// A contour 25 times as long comes in more blocks, not in longer ones.
TEST(MemoryExhausted, NotByLongContours) {
  const Field field = Field::build(test::sphere_mesh(2).view()).value();
  for (const double tolerance : {0.1, 0.02}) {
    BlockLengths sink;
    ASSERT_TRUE(contour_points(field, -0.2, {tolerance}, sink));
    EXPECT_GT(sink.total(), 0U);
    EXPECT_LE(sink.longest() * sizeof(ContourPoint), std::size_t{4} << 20) << tolerance;
  }
}

}  // namespace
}  // namespace cdfr
