#include "core/bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace cdfr {
namespace {

std::span<const std::byte> as_bytes(const auto& array) { return std::as_bytes(std::span(array)); }

TEST(Bytes, ReadsBothOrders) {
  const std::array<std::uint8_t, 8> data = {1, 2, 3, 4, 5, 6, 7, 8};
  const std::byte* first = as_bytes(data).data();
  EXPECT_EQ(load_little<std::uint16_t>(first), 0x0201);
  EXPECT_EQ(load_big<std::uint16_t>(first), 0x0102);
  EXPECT_EQ(load_little<std::uint32_t>(first + 1), 0x05040302U);
  EXPECT_EQ(load_big<std::uint32_t>(first + 1), 0x02030405U);
  EXPECT_EQ(load_little<std::uint64_t>(first), 0x0807060504030201ULL);
  EXPECT_EQ(load_big<std::uint64_t>(first), 0x0102030405060708ULL);
}

TEST(Bytes, ReadsSignedAndFloatingNumbers) {
  const std::array<std::uint8_t, 8> minus_two = {0xc0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(load_big<double>(as_bytes(minus_two).data()), -2.0);
  EXPECT_EQ(load_big<float>(as_bytes(minus_two).data()), -2.0F);
  const std::array<std::uint8_t, 2> minus_one = {0xff, 0xff};
  EXPECT_EQ(load_little<std::int16_t>(as_bytes(minus_one).data()), -1);
  EXPECT_EQ(load_little<std::int8_t>(as_bytes(minus_one).data()), -1);
}

TEST(Bytes, ReaderStopsAtTheEndAndStaysThere) {
  const std::array<std::uint8_t, 5> data = {1, 0, 0, 0, 9};
  ByteReader reader(as_bytes(data));
  EXPECT_EQ(reader.little<std::uint32_t>(), 1U);
  EXPECT_EQ(reader.little<std::uint16_t>(), std::nullopt);
  EXPECT_EQ(reader.offset(), 4U);
  EXPECT_EQ(reader.big<std::uint8_t>(), 9);
  EXPECT_EQ(reader.remaining(), 0U);
  EXPECT_FALSE(reader.little<std::uint8_t>());
}

TEST(Bytes, ReaderRefusesCountsThatWouldOverflow) {
  const std::array<std::uint8_t, 3> data = {1, 2, 3};
  ByteReader reader(as_bytes(data));
  EXPECT_TRUE(reader.take(1));
  EXPECT_FALSE(reader.take(std::numeric_limits<std::uint64_t>::max()));
  EXPECT_EQ(reader.remaining(), 2U);
  EXPECT_TRUE(reader.take(0)->empty());
}

}  // namespace
}  // namespace cdfr
