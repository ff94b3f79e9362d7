// Damage with a checksum that fits it, as an attacker would make: a field of it stays within its own
// arrays, and verify tells. The sanitizers watch.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "cdfr/parts/part.h"
#include "store/format.h"
#include "store/stored_bytes.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

class StoreForged : public StoreTest {
 protected:
  struct Extent {
    std::size_t begin = 0, end = 0;
  };

  std::string small_field() const { return small_field(test::sphere_mesh(1)); }
  std::string small_field(const Mesh& mesh) const {
    BuildOptions options;
    options.max_triangles_per_leaf = 8;
    options.max_level = 2;
    return saved(Field::build(mesh.view(), options).value(), "mm");
  }
  /// Winding decides: closed twice over, or open.
  static Mesh wound(bool open) {
    Mesh mesh = test::sphere_mesh(1);
    if (open) mesh.triangles.pop_back();
    if (!open) mesh.triangles.insert(mesh.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    return mesh;
  }
  static format::Counts counts_of(const std::string& bytes) {
    format::Counts counts;
    std::memcpy(&counts, bytes.data() + sizeof(format::Head), sizeof counts);
    return counts;
  }
  static std::vector<Extent> sections_of(const std::string& bytes) {
    const format::Counts counts = counts_of(bytes);
    const format::Places places(counts);
    std::vector<Extent> found;
    for (std::size_t i = 0; i < format::checksums; ++i)
      found.push_back({places.at[i], places.at[i] + counts[i] * format::element_size[i]});
    return found;
  }

  /// What load, verify and queries do with it; every query must end within the arrays. True if a query
  /// answered.
  bool survives(std::string bytes) const {
    seal(bytes);
    put_bytes(file("forged.cdfr"), bytes);
    const Result<StoredField> loaded = load(file("forged.cdfr"));
    if (!loaded) {
      const Code code = loaded.error().code;
      EXPECT_TRUE(code == Code::file_format || code == Code::file_truncated || code == Code::file_version);
      EXPECT_FALSE(loaded.error().text.empty());
      return false;
    }
    return use(loaded->field);
  }
  static bool use(const Field& field) {
    test::Random random(3);
    for (int i = 0; i < 24; ++i) {
      const Vec3 p = random.in({{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}});
      const Closest c = field.closest(i % 5 == 0 ? Vec3{p.x * 100, p.y * 100, p.z} : p);
      EXPECT_TRUE(c.triangle < field.report().triangles || c.triangle == no_index);
      static_cast<void>(field.distance(p));
    }
    const Box box = field.domain();
    static_cast<void>(field.closest(box.lo));
    static_cast<void>(field.closest(box.hi));
    static_cast<void>(field.stats());
    static_cast<void>(field.checksum());
    for (std::size_t i = 0; i < field.leaf_count(); i += 1 + field.leaf_count() / 8)
      static_cast<void>(field.leaf(i));
    std::vector<Vec3> points;
    for (int i = 0; i < 70; ++i) points.push_back(random.in({{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}}));
    std::vector<double> distances(points.size());
    static_cast<void>(field.distance(Points(points), distances));
    Grid grid;
    grid.origin = {-1.2, -1.2, -1.2};
    grid.spacing = {0.3, 0.3, 0.3};
    grid.size = {9, 9, 9};
    std::vector<double> samples(grid.count());
    static_cast<void>(field.distance(grid, samples));
    return !std::isnan(field.distance({0.1, 0.2, 0.3}));
  }
};

TEST_F(StoreForged, UndamagedIsTaken) {
  EXPECT_TRUE(survives(small_field()));
  EXPECT_TRUE(survives(small_field(wound(true))));
  EXPECT_TRUE(survives(small_field(wound(false))));
}

TEST_F(StoreForged, SingleBitsInEverySection) {
  for (const Mesh& mesh : {test::sphere_mesh(1), wound(true), wound(false)}) {
    const std::string whole = small_field(mesh);
    test::Random random(7);
    for (const Extent& s : sections_of(whole)) {
      if (s.begin == s.end) continue;
      for (int i = 0; i < 100; ++i) {
        std::string bytes = whole;
        const std::uint64_t bit = random.below(8 * (s.end - s.begin));
        char& byte = bytes[s.begin + bit / 8];
        byte = static_cast<char>(byte ^ (1 << bit % 8));
        survives(bytes);
      }
    }
  }
}

/// A mesh of four triangles has a group of four lanes; the other four have nothing behind them.
TEST_F(StoreForged, LanesWithoutATriangle) {
  std::string bytes = small_field(make_part("tetrahedron").value());
  ASSERT_TRUE(survives(bytes));
  const Extent entries = sections_of(bytes)[format::entries];
  for (std::size_t at = entries.begin; at < entries.end; at += sizeof(Entry)) {
    Entry entry = Entry::of_group(0, 0, 0xff);
    std::memcpy(bytes.data() + at, &entry, sizeof entry);
  }
  EXPECT_FALSE(survives(bytes));
}

/// A checksum that fits hides nothing from the build.
TEST_F(StoreForged, VerifyTellsSingleBitsInEverySection) {
  for (const Mesh& mesh : {test::sphere_mesh(1), wound(true)}) {
    const std::string whole = small_field(mesh);
    const std::vector<Extent> sections = sections_of(whole);
    test::Random random(8);
    for (std::size_t section = format::levels; section < sections.size(); ++section) {
      const Extent& s = sections[section];
      for (int i = 0; i < 8 && s.begin < s.end; ++i) {
        std::string bytes = whole;
        std::uint64_t bit = random.below(8 * (s.end - s.begin));
        if (section == format::triangles && bit / 8 % sizeof(ExactTriangle) >= offsetof(ExactTriangle, patch))
          continue;  // any patch may be right
        char& byte = bytes[s.begin + bit / 8];
        byte = static_cast<char>(byte ^ (1 << bit % 8));
        seal(bytes);
        put_bytes(file("forged.cdfr"), bytes);
        EXPECT_FALSE(verify(file("forged.cdfr"))) << format::section_name[section] << " bit " << bit;
      }
    }
    seal(const_cast<std::string&>(whole));
    put_bytes(file("forged.cdfr"), whole);
    EXPECT_TRUE(verify(file("forged.cdfr")));
  }
}

/// An edge without a pseudonormal is a collapsed one; a query on any other would look past the array.
TEST_F(StoreForged, RealEdgesWithoutAnIdStayInside) {
  std::string bytes = small_field();
  const Extent records = sections_of(bytes)[format::records];
  for (std::size_t at = records.begin; at < records.end; at += sizeof(TriangleRecord)) {
    std::memset(bytes.data() + at + offsetof(TriangleRecord, edges), 0xff, sizeof(TriangleRecord::edges));
  }
  survives(bytes);
}

TEST_F(StoreForged, WordsOfTheWorstKind) {
  const std::string whole = small_field();
  const std::vector<Extent> sections = sections_of(whole);
  const std::uint64_t words[] = {0,
                                 1,
                                 0x7fffffffU,
                                 0x80000000U,
                                 0xffffffffU,
                                 ~std::uint64_t{0},
                                 0x7ff0000000000000U,
                                 0xfff0000000000000U,
                                 0x7fefffffffffffffU,
                                 0x8000000080000000U,
                                 0x7f8000007f800000U};
  test::Random random(8);
  for (const Extent& s : sections) {
    for (const std::uint64_t word : words) {
      for (int i = 0; i < 10 && s.end - s.begin >= 8; ++i) {
        std::string bytes = whole;
        const std::size_t at = s.begin + 4 * random.below((s.end - s.begin) / 4 - 1);
        std::memcpy(bytes.data() + at, &word, 8);
        survives(bytes);
        // Half of it: the neighbour keeps its meaning.
        bytes = whole;
        std::memcpy(bytes.data() + at, &word, 4);
        survives(bytes);
      }
    }
  }
}

/// The trees are the part whose damage could send a walk in circles: every node word takes every other's
/// value.
TEST_F(StoreForged, NodesThatPointAtEachOther) {
  const std::string whole = small_field();
  const std::vector<Extent> sections = sections_of(whole);
  for (const format::Section section :
       {format::top, format::block_nodes, format::index_grid, format::index_nodes, format::bvh_nodes}) {
    const Extent s = sections[section];
    for (std::size_t at = s.begin; at + 4 <= s.end; at += 4 * (1 + (s.end - s.begin) / 400)) {
      for (const std::uint32_t value : {0U, 1U, 8U, 9U, 0x80000000U, 0x80000001U, 0xffffffffU, 0x7ffffff8U}) {
        std::string bytes = whole;
        std::memcpy(bytes.data() + at, &value, 4);
        survives(bytes);
      }
    }
  }
}

TEST_F(StoreForged, SectionsThatAreMissing) {
  const std::string whole = small_field();
  const format::Counts counts = counts_of(whole);
  const format::Places places(counts);
  for (std::size_t i = 0; i < format::section_count; ++i) {
    if (counts[i] == 0) continue;
    std::string bytes = whole;
    bytes.erase(places.at[i], places.at[i + 1] - places.at[i]);
    const std::uint64_t none = 0, size = bytes.size();
    std::memcpy(bytes.data() + sizeof(format::Head) + 8 * i, &none, 8);
    std::memcpy(bytes.data() + 16, &size, 8);
    const bool harmless = i == format::unit || i == format::levels;
    EXPECT_TRUE(!survives(bytes) || harmless) << format::section_name[i];
  }
}

}  // namespace
}  // namespace cdfr
