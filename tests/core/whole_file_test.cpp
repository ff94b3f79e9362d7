#include "core/whole_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/scratch.h"

namespace cdfr {
namespace {

static_assert(std::is_nothrow_move_constructible_v<WholeFile> && !std::is_copy_constructible_v<WholeFile>);

class WholeFileTest : public ScratchTest {};

TEST_F(WholeFileTest, NothingIsThereUntilFinish) {
  const auto path = folder() / "out.bin";
  {
    auto file = WholeFile::create(path);
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write("abc"));
    EXPECT_FALSE(std::filesystem::exists(path));
    ASSERT_TRUE(file->finish());
    EXPECT_EQ(text_of(path), "abc");
  }
  EXPECT_EQ(names(), std::vector<std::string>{"out.bin"});
}

TEST_F(WholeFileTest, AbandonedLeavesTheOldFileAndNoOther) {
  const auto path = folder() / "out.bin";
  put_text(path, "old");
  {
    auto file = WholeFile::create(path);
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write(std::string(1 << 20, 'x')));
    WholeFile moved = std::move(*file);
    ASSERT_TRUE(moved.write("y"));
  }
  EXPECT_EQ(text_of(path), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"out.bin"});
}

TEST_F(WholeFileTest, PiecesOfAnySizeArriveInOrderAndCanBePatched) {
  const auto path = folder() / "out.bin";
  auto file = WholeFile::create(path);
  ASSERT_TRUE(file);
  std::string expected;
  for (const std::size_t size : {0, 1, 3, 262143, 1, 262144, 262145, 5, 1000000, 0, 7}) {
    const std::string piece(size, static_cast<char>('a' + expected.size() % 26));
    ASSERT_TRUE(file->write(piece));
    expected += piece;
    EXPECT_EQ(file->size(), expected.size());
  }
  for (const std::size_t offset : {std::size_t{0}, std::size_t{262142}, expected.size() - 4}) {
    ASSERT_TRUE(file->write_at(offset, "1234"));
    expected.replace(offset, 4, "1234");
  }
  ASSERT_TRUE(file->write("end"));
  ASSERT_TRUE(file->finish());
  EXPECT_TRUE(text_of(path) == expected + "end");
}

TEST_F(WholeFileTest, RefusesTargetsThatAreNoRegularFile) {
  std::filesystem::create_directory(folder() / "directory");
  ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
  put_text(folder() / "file", "old");
  std::filesystem::create_symlink("file", folder() / "link");
  std::filesystem::create_symlink("nowhere", folder() / "dangling");
  const std::vector<std::pair<std::filesystem::path, std::string>> cases = {
      {folder() / "directory", "is a directory"},
      {folder() / "pipe", "is a pipe"},
      {folder() / "link", "is a symbolic link"},
      {folder() / "dangling", "is a symbolic link"},
      {"/dev/null", "is a device"},
      {folder() / "none" / "x", "No such file"},
      {folder() / "file" / "x", "Not a directory"},
      {"", "is no file name"},
      {folder() / "directory" / "", "is no file name"},
      {folder() / "..", "is no file name"},
      {std::string("a\0b", 3), "zero byte"}};
  for (const auto& [path, reason] : cases) {
    const auto file = WholeFile::create(path);
    ASSERT_FALSE(file) << path;
    EXPECT_EQ(file.error().code, Code::file_write);
    EXPECT_NE(file.error().text.find(reason), std::string::npos) << path << ": " << file.error().text;
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"dangling", "directory", "file", "link", "pipe"}));
  EXPECT_EQ(text_of(folder() / "file"), "old");
}

TEST_F(WholeFileTest, RefusesADirectoryThatComesUpMeanwhile) {
  const auto path = folder() / "out";
  {
    auto file = WholeFile::create(path);
    ASSERT_TRUE(file);
    std::filesystem::create_directory(path);
    const auto finished = file->finish();
    ASSERT_FALSE(finished);
    EXPECT_EQ(finished.error().code, Code::file_write);
  }
  EXPECT_TRUE(std::filesystem::is_directory(path));
  EXPECT_EQ(names().size(), 1U);
}

TEST_F(WholeFileTest, RefusesWhatMayNotBeWritten) {
  if (::geteuid() == 0) GTEST_SKIP() << "the superuser may write everywhere";
  put_text(folder() / "locked", "old");
  ASSERT_EQ(::chmod((folder() / "locked").c_str(), 0444), 0);
  EXPECT_FALSE(WholeFile::create(folder() / "locked"));
  ASSERT_EQ(::chmod(folder().c_str(), 0555), 0);
  EXPECT_FALSE(WholeFile::create(folder() / "fresh"));
  ASSERT_EQ(::chmod(folder().c_str(), 0755), 0);
  EXPECT_EQ(names(), std::vector<std::string>{"locked"});
}

TEST_F(WholeFileTest, PermissionsFollowTheUmask) {
  const mode_t before = ::umask(027);
  auto file = WholeFile::create(folder() / "out");
  ::umask(before);
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->finish());
  struct stat status {};
  ASSERT_EQ(::stat((folder() / "out").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
}

TEST_F(WholeFileTest, LongestLegalNameWorks) {
  const auto path = folder() / std::string(255, 'n');
  auto file = WholeFile::create(path);
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->finish());
  EXPECT_TRUE(std::filesystem::exists(path));
}

/// What the child of the next test does; the return value names the first promise that was broken.
int write_until_full(const std::filesystem::path& path) {
  ::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{1000000, 1000000};
  if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 1;
  auto file = WholeFile::create(path);
  if (!file) return 2;
  const std::string piece(100000, 'x');
  Result<void> written;
  for (int i = 0; i < 20 && written; ++i) written = file->write(piece);
  if (written) return 3;
  if (written.error().code != Code::file_write || written.error().where != 1000000) return 4;
  if (file->write("more") || file->write_at(0, "x")) return 5;
  const auto finished = file->finish();
  if (finished || finished.error().where != 1000000) return 6;
  return 0;
}

TEST_F(WholeFileTest, FullDiskLeavesTheOldFile) {
  const auto path = folder() / "out.bin";
  put_text(path, "old");
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) ::_exit(write_until_full(path));
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(text_of(path), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"out.bin"});
}

}  // namespace
}  // namespace cdfr
