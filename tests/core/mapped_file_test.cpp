#include "core/mapped_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace cdfr {
namespace {

class MappedFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "cdfr-mapped-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  std::filesystem::path folder_;
};

TEST_F(MappedFileTest, RefusesWhatIsNoRegularFile) {
  ASSERT_EQ(::mkfifo((folder_ / "fifo").c_str(), 0600), 0);
  for (const std::filesystem::path& path :
       {folder_ / "fifo", folder_, folder_ / "missing", std::filesystem::path("/dev/zero"),
        std::filesystem::path("/dev/null"), std::filesystem::path()}) {
    const auto file = MappedFile::open(path);
    ASSERT_FALSE(file) << path;
    EXPECT_EQ(file.error().code, Code::file_open) << path;
    EXPECT_EQ(file.error().text.find('\n'), std::string::npos);
    EXPECT_FALSE(file.error().text.empty());
  }
}

TEST_F(MappedFileTest, EmptyFileHasNoBytes) {
  const auto file = MappedFile::open(write("empty", ""));
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->bytes().empty());
}

TEST_F(MappedFileTest, MovesAndOutlivesTheName) {
  const auto path = write("text", "hello");
  auto file = MappedFile::open(path);
  ASSERT_TRUE(file);
  std::filesystem::remove(path);
  MappedFile moved = std::move(*file);
  EXPECT_TRUE(file->bytes().empty());
  ASSERT_EQ(moved.bytes().size(), 5U);
  EXPECT_EQ(static_cast<char>(moved.bytes()[4]), 'o');
  auto other = MappedFile::open(write("other", "x"));
  ASSERT_TRUE(other);
  moved = std::move(*other);
  EXPECT_EQ(moved.bytes().size(), 1U);
}

TEST_F(MappedFileTest, FollowsLinksToRegularFiles) {
  std::filesystem::create_symlink(write("target", "abc"), folder_ / "link");
  const auto file = MappedFile::open(folder_ / "link");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->bytes().size(), 3U);
}

}  // namespace
}  // namespace cdfr
