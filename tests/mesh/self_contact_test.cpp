#include "mesh/self_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"
#include "core/parallel.h"
#include "geometry/exact_contact.h"
#include "mesh/samples.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

struct Prepared {
  explicit Prepared(const Mesh& mesh) : topology(weld_topology(mesh.view())), tree(build_bvh(mesh.view())) {
    store = gather_triangles(mesh.view(), topology, tree.order);
  }
  SearchSpace space() const { return {store, tree.bvh}; }

  Topology topology;
  BvhAndOrder tree;
  TriangleStore store;
};

/// By triangle number.
std::vector<std::uint8_t> contacts_of(const Mesh& mesh, unsigned threads = 1) {
  const Prepared prepared(mesh);
  const Run run{threads, nullptr, nullptr};
  Progress progress(run);
  Large<std::uint8_t> by_slot;
  with_threads(run, [&] { by_slot = self_contacts(prepared.space(), progress); });
  EXPECT_EQ(by_slot.size(), mesh.triangles.size());
  std::vector<std::uint8_t> result(by_slot.size());
  for (std::size_t slot = 0; slot < by_slot.size(); ++slot) result[prepared.tree.order[slot]] = by_slot[slot];
  return result;
}

std::size_t count_of(const Mesh& mesh) {
  const auto contacts = contacts_of(mesh);
  return static_cast<std::size_t>(std::count(contacts.begin(), contacts.end(), 1));
}

/// All pairs, in rational numbers.
std::vector<std::uint8_t> contacts_exactly(const Mesh& mesh) {
  const Topology topology = weld_topology(mesh.view());
  std::vector<ContactTriangle> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    triangles.push_back(
        {{mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]]}, topology.triangles[t]});
  }
  std::vector<std::uint8_t> result(triangles.size(), 0);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (test::meet_exactly(triangles[i], triangles[j])) result[i] = result[j] = 1;
    }
  }
  return result;
}

Mesh cube() {
  Mesh mesh;
  mesh.vertices = samples::cube_vertices();
  mesh.triangles = samples::cube_triangles();
  return mesh;
}

void append(Mesh& mesh, const Mesh& other, const Vec3& shift) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vec3& v : other.vertices) mesh.vertices.push_back({v.x + shift.x, v.y + shift.y, v.z + shift.z});
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

TEST(SelfContact, AgreesWithAllPairsInRationals) {
  test::Random random(31);
  std::size_t touching = 0, all = 0;
  for (int round = 0; round < 6; ++round) {
    Mesh mesh;
    const std::uint64_t size = 5 + 3 * round;
    for (std::uint32_t i = 0; i < 60; ++i) {
      for (int k = 0; k < 3; ++k) {
        const auto c = [&] { return static_cast<double>(random.below(size)); };
        // Far apart corners would leave nothing without a contact.
        const Vec3 near = k == 0 ? Vec3{} : mesh.vertices[3 * i];
        const auto step = [&] { return static_cast<double>(random.below(5)) - 2; };
        mesh.vertices.push_back(k == 0 ? Vec3{c(), c(), c()}
                                       : Vec3{near.x + step(), near.y + step(), near.z + step()});
      }
      mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto expected = contacts_exactly(mesh);
    EXPECT_EQ(contacts_of(mesh), expected);
    touching += std::accumulate(expected.begin(), expected.end(), std::size_t{0});
    all += expected.size();
  }
  EXPECT_GT(touching, all / 10);
  EXPECT_LT(touching, all * 19 / 20);
}

TEST(SelfContact, MadePartsAndSpheresHaveNone) {
  for (const std::string_view name : part_names()) {
    EXPECT_EQ(count_of(make_part(name).value()), 0U) << name;
  }
  EXPECT_EQ(count_of(test::sphere_mesh(4, 3.7, {1e3, -2e3, 0.1})), 0U);
}

TEST(SelfContact, FacesThatTouchFaces) {
  Mesh stacked = cube();
  append(stacked, cube(), {0.25, 0.25, 1});
  const auto contacts = contacts_of(stacked);
  EXPECT_EQ(contacts, contacts_exactly(stacked));
  EXPECT_GE(std::accumulate(contacts.begin(), contacts.end(), 0), 4);
  Mesh apart = cube();
  append(apart, cube(), {0.25, 0.25, 1 + 0x1p-50});
  EXPECT_EQ(count_of(apart), 0U);
}

TEST(SelfContact, CubesThatShareACornerOrAnEdgeHaveNone) {
  Mesh corner = cube();
  append(corner, cube(), {1, 1, 1});
  EXPECT_EQ(count_of(corner), 0U);
  Mesh edge = cube();
  append(edge, cube(), {1, 1, 0});
  EXPECT_EQ(count_of(edge), 0U);
}

TEST(SelfContact, DuplicatesAndTrianglesOfNoAreaDoNotCount) {
  Mesh mesh = cube();
  const Triangle t = mesh.triangles[3];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  mesh.triangles.push_back({t[0], t[2], t[1]});
  mesh.vertices.push_back({0.5, 0.5, -1});
  mesh.vertices.push_back({0.5, 0.5, 0.5});
  mesh.vertices.push_back({0.5, 0.5, 2});
  mesh.triangles.push_back({8, 9, 10});
  mesh.triangles.push_back({0, 0, 6});
  EXPECT_EQ(count_of(mesh), 0U);
}

TEST(SelfContact, TheSameAtAnyScaleAndForAnyNumberOfThreads) {
  const Mesh mesh = test::soup(3000, {{-1, -1, -1}, {30, 30, 1}}, 9);
  const auto once = contacts_of(mesh);
  EXPECT_GT(std::accumulate(once.begin(), once.end(), 0), 100);
  for (const unsigned threads : {2U, 7U}) EXPECT_EQ(contacts_of(mesh, threads), once);
  for (const double factor : {0x1p-150, 0x1p190}) {
    Mesh scaled = mesh;
    for (Vec3& v : scaled.vertices) v = {v.x * factor, v.y * factor, v.z * factor};
    EXPECT_EQ(contacts_of(scaled), once) << factor;
  }
}

TEST(SelfContact, ManyCrossingTrianglesStayCheap) {
  // 4e8 pairs, all of which cross or nearly do: each triangle is content with its first.
  const auto contacts = contacts_of(test::soup(20000, {{0, 0, 0}, {1, 1, 1}}, 3));
  EXPECT_EQ(std::count(contacts.begin(), contacts.end(), 1), 20000);
}

TEST(SelfContact, CanBeCancelled) {
  const Prepared prepared(cube());
  cdfr::Run run;
  run.tick = [](void*, double) noexcept { return false; };
  Progress progress(run);
  EXPECT_EQ(self_contacts(prepared.space(), progress).size(), 12U);
  EXPECT_TRUE(progress.cancelled());
}

class PublicModel : public testing::TestWithParam<std::pair<const char*, bool>> {};

TEST_P(PublicModel, HasContactsAsExpected) {
  const auto path = std::filesystem::path(CDFR_SHARED_DATA) / "public" / GetParam().first;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data at " << path;
  EXPECT_EQ(count_of(read_mesh(path).value()) > 0, GetParam().second);
}

INSTANTIATE_TEST_SUITE_P(SelfContact, PublicModel,
                         testing::Values(std::pair{"dirty_pub/nist1_ref.stl", false},
                                         std::pair{"dirty_pub/nist1_holes.stl", false},
                                         std::pair{"dirty_pub/nist1_dup_faces.stl", false},
                                         std::pair{"dirty_pub/nist1_self_intersect_two_copies.stl", true},
                                         std::pair{"tess/kcl_enclosure.stl", true}));

}  // namespace
}  // namespace cdfr
