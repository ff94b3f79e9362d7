// A file is whole or not there, and nothing is left beside it.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "store/stored_bytes.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

class StoreWrite : public StoreTest {
 protected:
  static Field small() { return Field::build(test::box_mesh({{0, 0, 0}, {1, 1, 1}}).view()).value(); }
  static Code failure_of(const std::filesystem::path& path) {
    const Result<void> done = save(small(), path);
    EXPECT_FALSE(done);
    if (done) return Code{};
    EXPECT_FALSE(done.error().text.empty());
    return done.error().code;
  }
};

TEST_F(StoreWrite, ReplacesAnOlderFileWhole) {
  const Field large = Field::build(test::sphere_mesh(4).view()).value();
  save(large, file(), "mm").value();
  const std::string expected = [this] {
    save(small(), file("other")).value();
    return bytes_of(file("other"));
  }();
  save(small(), file()).value();
  EXPECT_EQ(bytes_of(file()), expected);
  save(large, file()).value();
  EXPECT_EQ(load(file()).value().field.checksum(), large.checksum());
  EXPECT_EQ(file_count(), 2U);
}

/// A field loaded from a file may be saved to that very file.
TEST_F(StoreWrite, OntoTheFileItCameFrom) {
  save(small(), file()).value();
  const std::string before = bytes_of(file());
  const StoredField stored = load(file()).value();
  save(stored.field, file(), stored.unit).value();
  EXPECT_EQ(bytes_of(file()), before);
}

TEST_F(StoreWrite, FailsByName) {
  EXPECT_EQ(failure_of(file("missing") / "field.cdfr"), Code::file_write);
  EXPECT_EQ(failure_of(folder()), Code::file_write);
  EXPECT_EQ(failure_of(""), Code::file_write);
  put_bytes(file("plain"), "x");
  EXPECT_EQ(failure_of(file("plain") / "field.cdfr"), Code::file_write);
  EXPECT_EQ(bytes_of(file("plain")), "x");
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(StoreWrite, FailsInAFolderThatCannotBeWritten) {
  if (::geteuid() == 0) GTEST_SKIP() << "root writes anywhere";
  const std::filesystem::path locked = file("locked");
  std::filesystem::create_directory(locked);
  ::chmod(locked.c_str(), 0500);
  EXPECT_EQ(failure_of(locked / "field.cdfr"), Code::file_write);
  ::chmod(locked.c_str(), 0700);
  EXPECT_TRUE(std::filesystem::is_empty(locked));
}

TEST_F(StoreWrite, FailsOnASystemThatTakesNoFiles) {
  // Read-only for root as well.
  if (!std::filesystem::exists("/proc/self")) GTEST_SKIP() << "no /proc here";
  EXPECT_EQ(failure_of("/proc/self/field.cdfr"), Code::file_write);
}

}  // namespace
}  // namespace cdfr
