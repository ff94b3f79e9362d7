// Damage with a checksum that fits it, as an attacker would make: load refuses, or gives a field that stays
// within its own arrays. The sanitizers watch.
#include <gtest/gtest.h>
#include <xxhash.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

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

  std::string small_field() const {
    BuildOptions options;
    options.max_triangles_per_leaf = 8;
    options.max_level = 2;
    return saved(Field::build(test::sphere_mesh(1).view(), options).value(), "mm");
  }
  static std::vector<Extent> sections_of(const std::string& bytes) {
    format::Counts counts;
    std::memcpy(&counts, bytes.data() + sizeof(format::Head), sizeof counts);
    std::vector<Extent> found;
    std::size_t at = sizeof(format::Head);
    for (std::size_t i = 0; i < format::section_count; ++i) {
      const std::size_t size = counts[i] * format::element_size[i];
      found.push_back({at, at + size});
      at += format::padded(size);
    }
    return found;
  }
  static void seal(std::string& bytes) {
    const std::size_t end = bytes.size() - 8;
    const std::uint64_t hash = XXH64(bytes.data(), end, 0);
    std::memcpy(bytes.data() + end, &hash, sizeof hash);
  }

  /// True if it was taken; then every query must end within the arrays.
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
    use(loaded->field);
    return true;
  }
  static void use(const Field& field) {
    const std::uint64_t triangles = field.stats().triangles;
    test::Random random(3);
    for (int i = 0; i < 24; ++i) {
      const Vec3 p = random.in({{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}});
      const Closest c = field.closest(i % 5 == 0 ? Vec3{p.x * 100, p.y * 100, p.z} : p);
      EXPECT_TRUE(c.triangle < triangles || c.triangle == no_index);
      static_cast<void>(field.distance(p));
    }
    const Box box = field.domain();
    static_cast<void>(field.closest(box.lo));
    static_cast<void>(field.closest(box.hi));
    static_cast<void>(field.checksum());
    for (std::size_t i = 0; i < field.leaf_count(); i += 1 + field.leaf_count() / 8)
      static_cast<void>(field.leaf(i));
  }
};

TEST_F(StoreForged, UndamagedIsTaken) { EXPECT_TRUE(survives(small_field())); }

TEST_F(StoreForged, SingleBitsInEverySection) {
  const std::string whole = small_field();
  const std::vector<Extent> sections = sections_of(whole);
  test::Random random(7);
  for (const Extent& s : sections) {
    if (s.begin == s.end) continue;
    for (int i = 0; i < 150; ++i) {
      std::string bytes = whole;
      const std::uint64_t bit = random.below(8 * (s.end - s.begin));
      char& byte = bytes[s.begin + bit / 8];
      byte = static_cast<char>(byte ^ (1 << bit % 8));
      survives(bytes);
    }
  }
}

/// An edge without a pseudonormal is a collapsed one; a query on any other would look past the array.
TEST_F(StoreForged, RealEdgesWithoutAnIdAreRefused) {
  std::string bytes = small_field();
  const Extent records = sections_of(bytes)[format::records];
  for (std::size_t at = records.begin; at < records.end; at += sizeof(TriangleRecord)) {
    std::memset(bytes.data() + at + offsetof(TriangleRecord, edges), 0xff, sizeof(TriangleRecord::edges));
  }
  EXPECT_FALSE(survives(bytes));
}

TEST_F(StoreForged, NormalsThatTheVerticesDoNotHaveAreRefused) {
  std::string bytes = small_field();
  const Extent triangles = sections_of(bytes)[format::triangles];
  std::memset(bytes.data() + triangles.begin + offsetof(TriangleShape, normal), 0,
              sizeof(TriangleShape::normal));
  EXPECT_FALSE(survives(bytes));
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
  for (const format::Section section : {format::top, format::block_nodes, format::bvh_nodes}) {
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
  const std::vector<Extent> sections = sections_of(whole);
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const std::size_t size = sections[i].end - sections[i].begin, padded = format::padded(size);
    if (size == 0) continue;
    std::string bytes = whole;
    bytes.erase(sections[i].begin, padded);
    const std::uint64_t none = 0, whole_size = bytes.size();
    std::memcpy(bytes.data() + sizeof(format::Head) + 8 * i, &none, 8);
    std::memcpy(bytes.data() + 16, &whole_size, 8);
    const bool harmless = i == format::unit || i == format::levels;
    EXPECT_TRUE(!survives(bytes) || harmless) << "section " << i;
  }
}

TEST_F(StoreForged, WhatIsTakenIsMostlyRight) {
  // A bit of padding between sections changes nothing that is read.
  const std::string whole = small_field();
  const std::vector<Extent> sections = sections_of(whole);
  std::string bytes = whole;
  ASSERT_NE(sections[format::unit].end % format::alignment, 0U);
  bytes[sections[format::unit].end] = 1;
  if (!survives(bytes)) return;
  EXPECT_EQ(load(file("forged.cdfr")).value().field.checksum(), load(file()).value().field.checksum());
}

}  // namespace
}  // namespace cdfr
