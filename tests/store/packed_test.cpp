// Packed files: smaller, the same field, and as hard to fool.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "store/stored_bytes.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/same.h"

namespace cdfr {
namespace {

class StorePacked : public StoreTest {
 protected:
  std::string packed(const Field& field) const {
    save(field, file("packed.cdfr"), "mm", Packing::zstd).value();
    return bytes_of(file("packed.cdfr"));
  }
};

TEST_F(StorePacked, IsSmallerAndTheSameField) {
  const Field built = Field::build(test::sphere_mesh(4).view()).value();
  const std::string plain = saved(built, "mm"), bytes = packed(built);
  EXPECT_LT(bytes.size(), plain.size());
  const StoredField stored = load(file("packed.cdfr")).value();
  EXPECT_EQ(stored.unit, "mm");
  EXPECT_TRUE(stored.field.status());
  EXPECT_EQ(stored.field.checksum(), built.checksum());
  test::Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.in({{-2, -2, -2}, {2, 2, 2}});
    ASSERT_TRUE(test::same_bits(stored.field.closest(p), built.closest(p)));
  }
  save(stored.field, file("again.cdfr"), stored.unit).value();
  EXPECT_EQ(bytes_of(file("again.cdfr")), plain);
  EXPECT_TRUE(verify(file("packed.cdfr")));
}

TEST_F(StorePacked, EveryTruncationAndManyBitsAreRefused) {
  const std::string whole = packed(Field::build(test::box_mesh({{0, 0, 0}, {1, 1, 1}}).view()).value());
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 2000)
    refusal_of(whole.substr(0, size));
  test::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = whole;
    const std::uint64_t bit = random.below(bytes.size() * 8);
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    put_bytes(file("bad.cdfr"), bytes);
    // zstd leaves a few bits of a frame's head without meaning.
    const Result<StoredField> loaded = load(file("bad.cdfr"));
    if (loaded) {
      EXPECT_TRUE(verify(file("bad.cdfr"))) << bit;
    }
  }
  refusal_of(whole + "x");
}

}  // namespace
}  // namespace cdfr
