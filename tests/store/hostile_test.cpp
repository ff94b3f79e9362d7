// Promise 6: what is no whole, undamaged file of a known version is refused by name.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "cdfr/contour/contour.h"
#include "store/format.h"
#include "store/stored_bytes.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

class StoreHostile : public StoreTest {
 protected:
  std::string small() const {
    return saved(Field::build(test::box_mesh({{0, 0, 0}, {1, 1, 1}}).view()).value(), "mm");
  }
  template <class T>
  static std::string with(std::string bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return bytes;
  }
};

TEST_F(StoreHostile, EveryTruncation) {
  const std::string whole = small();
  ASSERT_LT(whole.size(), 60000U);
  put_bytes(file("short.cdfr"), whole);
  for (std::size_t size = whole.size(); size-- > 0;) {
    std::filesystem::resize_file(file("short.cdfr"), size);
    ASSERT_EQ(refusal_at(file("short.cdfr")),
              size < format::magic.size() ? Code::file_format : Code::file_truncated)
        << size;
  }
}

TEST_F(StoreHostile, MoreBytesThanTheHeadSays) {
  const std::string whole = small();
  for (const std::size_t more : {1U, 8U, 64U, 100000U}) {
    const Code code = refusal_of(whole + std::string(more, '\0'));
    EXPECT_TRUE(code == Code::file_truncated || code == Code::file_format);
  }
}

TEST_F(StoreHostile, TenThousandSingleBits) {
  const std::string whole = small();
  test::Random random(2024);
  for (int i = 0; i < 10000; ++i) {
    std::string bytes = whole;
    const std::uint64_t bit = random.below(bytes.size() * 8);
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    put_bytes(file("bad.cdfr"), bytes);
    const Result<StoredField> loaded = load(file("bad.cdfr"));
    if (loaded) {
      // All of so small a file is one block, whose checksum the first query meets.
      ASSERT_TRUE(std::isnan(loaded->field.distance({0.5, 0.25, 0.125}))) << bit;
      ASSERT_EQ(loaded->field.status().error().code, Code::file_format) << bit;
    } else {
      const Code code = loaded.error().code;
      ASSERT_TRUE(code == Code::file_format || code == Code::file_truncated || code == Code::file_version)
          << bit;
    }
    if (i % 50 == 0) {
      EXPECT_FALSE(verify(file("bad.cdfr"))) << bit;
    }
  }
}

TEST_F(StoreHostile, DamageIsMetWhereItIsRead) {
  const Field built = Field::build(test::sphere_mesh(4).view()).value();
  std::string bytes = saved(built);
  format::Counts counts;
  std::memcpy(&counts, bytes.data() + sizeof(format::Head), sizeof counts);
  ASSERT_GT(bytes.size(), 4 * GuardedMap::block_size);
  const std::size_t at = format::Places(counts).at[format::scan_groups + 1] - 100;
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  put_bytes(file("bad.cdfr"), bytes);
  const StoredField stored = load(file("bad.cdfr")).value();
  EXPECT_TRUE(stored.field.status());
  test::Random random(5);
  bool met = false;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.in({{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}});
    const double distance = stored.field.distance(p);
    met = met || std::isnan(distance);
    // Right or none, and none for good.
    ASSERT_TRUE(met ? std::isnan(distance) && std::isnan(stored.field.closest(p).distance)
                    : distance == built.distance(p));
  }
  EXPECT_TRUE(met);
  const Error error = stored.field.status().error();
  EXPECT_EQ(error.code, Code::file_format);
  EXPECT_EQ(error.where, at / GuardedMap::block_size * GuardedMap::block_size);
  std::vector<Vec3> points(10);
  std::vector<double> out(10);
  EXPECT_EQ(stored.field.distance(Points(points), out).error().code, Code::file_format);
  EXPECT_EQ(contour_points(stored.field, 0.1, {}).error().code, Code::file_format);
  EXPECT_EQ(save(stored.field, file("copy.cdfr")).error().code, Code::file_format);
  const Result<void> verified = verify(file("bad.cdfr"));
  ASSERT_FALSE(verified);
  EXPECT_EQ(verified.error().where, error.where);
  EXPECT_NE(verified.error().text.find(" element "), std::string::npos) << verified.error().text;
}

TEST_F(StoreHostile, AFileThatIsCutShortUnderTheMap) {
  const Field built = Field::build(test::sphere_mesh(4).view()).value();
  const std::string whole = saved(built);
  for (const double kept : {0.0, 0.01, 0.3, 0.6, 0.9}) {
    for (const bool touched : {false, true}) {
      put_bytes(file("cut.cdfr"), whole);
      const StoredField stored = load(file("cut.cdfr")).value();
      test::Random random(6);
      const auto ask = [&] {
        const Vec3 p = random.in({{-2, -2, -2}, {2, 2, 2}});
        const double distance = stored.field.distance(p);
        EXPECT_TRUE(std::isnan(distance) || distance == built.distance(p));
        return distance;
      };
      for (int i = 0; i < 300 && touched; ++i) ask();
      const auto size = static_cast<std::uintmax_t>(kept * static_cast<double>(whole.size()));
      std::filesystem::resize_file(file("cut.cdfr"), size);
      EXPECT_FALSE(stored.field.status());
      for (int i = 0; i < 300; ++i) ask();
      if (kept < 0.5) {
        EXPECT_TRUE(std::isnan(ask()));
      }
      static_cast<void>(stored.field.stats());
      std::filesystem::remove(file("cut.cdfr"));
    }
  }
}

TEST_F(StoreHostile, AFileThatIsWrittenOrReplacedUnderTheMap) {
  const Field built = Field::build(test::sphere_mesh(3).view()).value();
  save(built, file()).value();
  const StoredField stored = load(file()).value();
  std::vector<Vec3> points(10);
  std::vector<double> out(10);
  EXPECT_TRUE(stored.field.distance(Points(points), out));
  save(built, file()).value();
  EXPECT_FALSE(stored.field.distance(Points(points), out));
  EXPECT_EQ(stored.field.status().error().code, Code::file_open);
  EXPECT_EQ(stored.field.distance({0.1, 0.2, 0.3}), built.distance({0.1, 0.2, 0.3}));
  const StoredField again = load(file()).value();
  std::filesystem::remove(file());
  EXPECT_FALSE(again.field.status());
}

TEST_F(StoreHostile, ANewerOrOlderVersion) {
  const std::string whole = small();
  for (const std::uint32_t version : {format::version + 1, format::version + 1000, 0U, 0xffffffffU}) {
    EXPECT_EQ(refusal_of(with(whole, 8, version)), Code::file_version) << version;
  }
  // The version speaks first: a newer layout need not have this one's sizes or checksum.
  EXPECT_EQ(refusal_of(with(whole, 8, format::version + 1) + "more"), Code::file_version);
}

TEST_F(StoreHostile, WrongMagic) {
  const std::string whole = small();
  for (std::size_t i = 0; i < format::magic.size(); ++i)
    EXPECT_EQ(refusal_of(with(whole, i, '?')), Code::file_format);
  EXPECT_EQ(refusal_of("solid cube\nendsolid cube\n"), Code::file_format);
  EXPECT_EQ(refusal_of(std::string(5000, '\0')), Code::file_format);
  // As text transfer would leave it.
  std::string text = whole;
  text.erase(4, 1);
  EXPECT_EQ(refusal_of(text), Code::file_format);
}

TEST_F(StoreHostile, WhatIsNoFile) {
  EXPECT_EQ(refusal_of(""), Code::file_format);
  EXPECT_EQ(refusal_at(folder()), Code::file_open);
  EXPECT_EQ(refusal_at(file("missing")), Code::file_open);
  EXPECT_EQ(refusal_at(""), Code::file_open);
  EXPECT_EQ(refusal_at("/dev/zero"), Code::file_open);
  EXPECT_EQ(refusal_at(std::filesystem::path(std::string(5000, 'a'))), Code::file_open);
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusal_at(file("pipe")), Code::file_open);
  std::filesystem::create_symlink(file("loop"), file("loop"));
  EXPECT_EQ(refusal_at(file("loop")), Code::file_open);
}

TEST_F(StoreHostile, HugeClaimedCounts) {
  const std::string whole = small();
  for (std::size_t section = 0; section < format::section_count; ++section) {
    for (const std::uint64_t count : {std::uint64_t{1} << 20, std::uint64_t{1} << 40, std::uint64_t{1} << 58,
                                      ~std::uint64_t{0}, std::uint64_t{0} - 64}) {
      std::string bytes = with(whole, sizeof(format::Head) + 8 * section, count);
      EXPECT_EQ(refusal_of(bytes), Code::file_format);
      seal(bytes);
      EXPECT_EQ(refusal_of(bytes), Code::file_format);
    }
  }
  std::string bytes = with(whole, 12, 0xffffffffU);
  seal(bytes);
  EXPECT_EQ(refusal_of(bytes), Code::file_format);
  bytes = with(whole, 16, ~std::uint64_t{0});
  seal(bytes);
  EXPECT_EQ(refusal_of(bytes), Code::file_truncated);
}

}  // namespace
}  // namespace cdfr
