// A field built into a file: the same bytes as built in memory, however often the work is killed.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fcntl.h>
#include <cstdint>
#include <string>

#include "cdfr/export/write.h"
#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"
#include "cdfr/store/build_file.h"
#include "store/stored_bytes.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/sanitized.h"

namespace cdfr {
namespace {

constexpr std::uint64_t mebi = std::uint64_t{1} << 20;

class BuildFile : public StoreTest {
 protected:
  std::filesystem::path mesh_file(const Mesh& mesh, const char* name = "mesh.stl") const {
    write_mesh(mesh.view(), file(name)).value();
    return file(name);
  }
  /// What save() writes of the same.
  std::string expected(const std::filesystem::path& mesh, const FileBuildOptions& options) const {
    Field field = Field::build(read_mesh(mesh).value().view(), options.build).value();
    save(field, file("expected.cdfr"), options.unit, options.packing).value();
    return bytes_of(file("expected.cdfr"));
  }
  /// In a process of its own, which ends in the middle if `after` microseconds are less than it takes. Its
  /// status.
  template <class Before>
  int in_child(const std::filesystem::path& mesh, const FileBuildOptions& options, Before before,
               useconds_t kill_after = 0) const {
    const pid_t child = ::fork();
    if (child == 0) {
      before();
      cdfr::Run run;
      run.threads = 1;  // TBB's workers are not there after a fork
      ::_exit(build_file(mesh, file(), options, run) ? 0 : 1);
    }
    if (kill_after > 0) {
      ::usleep(kill_after);
      ::kill(child, SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
  }
};

TEST_F(BuildFile, IsTheSameFileAsSave) {
  Mesh open = test::sphere_mesh(4);
  open.triangles.resize(open.triangles.size() - 100);
  Mesh twice = test::sphere_mesh(3);
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
  for (const Mesh& mesh : {test::sphere_mesh(4), open, twice, test::soup(80, {{0, 0, 0}, {1, 1, 1}}, 5)}) {
    const auto path = mesh_file(mesh);
    FileBuildOptions options;
    options.unit = "mm";
    options.build.max_triangles_per_leaf = 20;
    for (const std::uint64_t memory : {std::uint64_t{0}, 1024 * mebi}) {
      options.memory = memory;
      const FileBuildReport report = build_file(path, file(), options).value();
      EXPECT_EQ(report.blocks_kept, 0U);
      EXPECT_TRUE(bytes_of(file()) == expected(path, options));
    }
    options.packing = Packing::zstd;
    build_file(path, file(), options).value();
    EXPECT_TRUE(bytes_of(file()) == expected(path, options));
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"expected.cdfr", "field.cdfr", "mesh.stl"}));
}

TEST_F(BuildFile, GoesOnAfterFiftyKills) {
  const auto path = mesh_file(test::sphere_mesh(test::sanitized ? 4 : 5));
  FileBuildOptions options;
  options.build.max_triangles_per_leaf = 40;
  const std::string whole = expected(path, options);
  put_bytes(file(), "old");
  test::Random random(50);
  for (int i = 0; i < 50; ++i) {
    in_child(
        path, options, [] {}, static_cast<useconds_t>(random.between(1e3, 2e5)));
    if (bytes_of(file()) == whole) put_bytes(file(), "old");  // it was faster: from the beginning once more
    ASSERT_TRUE(bytes_of(file()) == "old");
  }
  build_file(path, file(), options).value();
  EXPECT_TRUE(bytes_of(file()) == whole);
  EXPECT_FALSE(std::filesystem::exists(file("field.cdfr.work")));
}

/// Cancelled between blocks, so that some are there, and then damaged.
TEST_F(BuildFile, KeepsWholeBlocksAndNoOthers) {
  const auto path = mesh_file(test::sphere_mesh(test::sanitized ? 4 : 5));
  FileBuildOptions options;
  options.build.max_triangles_per_leaf = 40;
  const std::string whole = expected(path, options);
  cdfr::Run run;
  run.threads = 1;
  run.tick = [](void*, double done) noexcept { return done < 0.8; };
  for (const char* damaged : {"", "entries", "leaves", "blocks", "job", "prepared"}) {
    EXPECT_EQ(build_file(path, file(), options, run).error().code, Code::cancelled);
    const auto work = file("field.cdfr.work");
    struct stat status {};
    ASSERT_EQ(::stat(work.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0700U);
    if (*damaged != '\0') {
      std::string bytes = bytes_of(work / damaged);
      ASSERT_FALSE(bytes.empty());
      bytes[bytes.size() * 2 / 3] ^= 1;
      put_bytes(work / damaged, bytes);
    }
    const Result<FileBuildReport> report = build_file(path, file(), options);
    if (std::string(damaged) == "prepared") {
      // Found where it is read: refused, never a wrong field.
      if (report) {
        EXPECT_TRUE(bytes_of(file()) == whole);
      }
      build_file(path, file(),
                 [&] {
                   auto fresh = options;
                   fresh.fresh = true;
                   return fresh;
                 }())
          .value();
    } else {
      ASSERT_TRUE(report) << damaged;
      EXPECT_EQ(report->blocks_kept > 0, std::string(damaged) != "job") << damaged;
      EXPECT_LT(report->blocks_kept, report->blocks);
    }
    EXPECT_TRUE(bytes_of(file()) == whole) << damaged;
  }
}

TEST_F(BuildFile, StartsOverForOtherWork) {
  const auto path = mesh_file(test::sphere_mesh(test::sanitized ? 4 : 5));
  FileBuildOptions options;
  options.build.max_triangles_per_leaf = 40;
  cdfr::Run run;
  run.tick = [](void*, double done) noexcept { return done < 0.8; };
  const auto interrupted = [&] { EXPECT_FALSE(build_file(path, file(), options, run)); };
  interrupted();
  FileBuildOptions other = options;
  other.fresh = true;
  EXPECT_EQ(build_file(path, file(), other).value().blocks_kept, 0U);
  interrupted();
  other = options;
  other.build.margin = 0.1;
  EXPECT_EQ(build_file(path, file(), other).value().blocks_kept, 0U);
  EXPECT_TRUE(bytes_of(file()) == expected(path, other));
  interrupted();
  mesh_file(test::sphere_mesh(3));
  EXPECT_EQ(build_file(path, file(), options).value().blocks_kept, 0U);
  EXPECT_TRUE(bytes_of(file()) == expected(path, options));
}

TEST_F(BuildFile, OneBuildAtATime) {
  const auto path = mesh_file(test::sphere_mesh(2));
  ASSERT_TRUE(std::filesystem::create_directory(file("field.cdfr.work")));
  const int lock = ::open(file("field.cdfr.work/lock").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(::flock(lock, LOCK_EX), 0);
  const Error error = build_file(path, file()).error();
  EXPECT_EQ(error.code, Code::file_write);
  EXPECT_NE(error.text.find("another build"), std::string::npos);
  ::close(lock);
  EXPECT_TRUE(build_file(path, file()));
}

TEST_F(BuildFile, FollowsNoLink) {
  const auto path = mesh_file(test::sphere_mesh(2));
  std::filesystem::create_directory(file("elsewhere"));
  std::filesystem::create_symlink(file("elsewhere"), file("field.cdfr.work"));
  EXPECT_EQ(build_file(path, file()).error().code, Code::file_write);
  EXPECT_TRUE(std::filesystem::is_empty(file("elsewhere")));
}

TEST_F(BuildFile, RefusesTooLittleMemoryWithTheLeastThatWorks) {
  const auto path = mesh_file(test::sphere_mesh(3));
  FileBuildOptions options;
  options.memory = mebi;
  const Error error = build_file(path, file(), options).error();
  EXPECT_EQ(error.code, Code::bad_option);
  const std::string text = error.text;
  const std::uint64_t least = std::stoull(text.substr(text.find_first_of("0123456789")));
  options.memory = least * mebi;
  EXPECT_TRUE(build_file(path, file(), options)) << text;
}

/// Files may not grow beyond a size: the disk is full at whatever write comes then.
TEST_F(BuildFile, AFullDiskLeavesTheOldFile) {
  const auto path = mesh_file(test::sphere_mesh(5));
  FileBuildOptions options;
  options.build.max_triangles_per_leaf = 40;
  put_bytes(file(), "old");
  for (const rlim_t limit :
       {rlim_t{100}, rlim_t{5000}, rlim_t{60000}, rlim_t{300000}, rlim_t{1000000}, rlim_t{2500000}}) {
    for (const std::uint64_t memory : {std::uint64_t{0}, 1024 * mebi}) {
      options.memory = memory;
      const int status = in_child(path, options, [limit] {
        ::signal(SIGXFSZ, SIG_IGN);
        const struct rlimit files { limit, limit };
        ::setrlimit(RLIMIT_FSIZE, &files);
      });
      ASSERT_TRUE(WIFEXITED(status)) << limit;
      EXPECT_EQ(WEXITSTATUS(status), 1) << limit;
      EXPECT_EQ(bytes_of(file()), "old");
    }
  }
  build_file(path, file(), options).value();
  EXPECT_TRUE(bytes_of(file()) == expected(path, options));
}

#ifndef __SANITIZE_ADDRESS__
/// The kernel counts: what is private and writable, whether it is used or not, may not exceed what was
/// promised.
TEST_F(BuildFile, WorksWithinItsMemory) {
  const auto path = mesh_file(make_part("cylinder-head", 6).value());
  FileBuildOptions options;
  options.memory = mebi;
  const std::string text = build_file(path, file(), options).error().text;
  const std::uint64_t least = std::stoull(text.substr(text.find_first_of("0123456789"))) * mebi;
  const auto status_under = [&](std::uint64_t memory) {
    options.memory = memory;
    return in_child(path, options, [least] {
      const struct rlimit data { least, least };
      ::setrlimit(RLIMIT_DATA, &data);
    });
  };
  const int bounded = status_under(least);
  ASSERT_TRUE(WIFEXITED(bounded));
  EXPECT_EQ(WEXITSTATUS(bounded), 0);
  EXPECT_TRUE(load(file()));
  // Without a bound it takes more than that, so the limit does bite.
  options.fresh = true;
  const int unbounded = status_under(0);
  EXPECT_FALSE(WIFEXITED(unbounded) && WEXITSTATUS(unbounded) == 0);
}
#endif

}  // namespace
}  // namespace cdfr
