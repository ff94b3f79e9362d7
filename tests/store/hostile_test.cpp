// Promise 6: what is no whole, undamaged file of a known version is refused by name.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdint>
#include <cstring>

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
  ASSERT_LT(whole.size(), 40000U);
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

TEST_F(StoreHostile, FiveThousandSingleBits) {
  const std::string whole = small();
  test::Random random(2024);
  for (int i = 0; i < 5000; ++i) {
    std::string bytes = whole;
    const std::uint64_t bit = random.below(bytes.size() * 8);
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    const Code code = refusal_of(bytes);
    ASSERT_TRUE(code == Code::file_format || code == Code::file_truncated || code == Code::file_version)
        << bit;
  }
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
      EXPECT_EQ(refusal_of(with(whole, sizeof(format::Head) + 8 * section, count)), Code::file_format);
    }
  }
  EXPECT_EQ(refusal_of(with(whole, 12, 0xffffffffU)), Code::file_format);
  EXPECT_EQ(refusal_of(with(whole, 16, ~std::uint64_t{0})), Code::file_truncated);
}

}  // namespace
}  // namespace cdfr
