#include "byte_sink.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "stop.h"

namespace cdfr::command {
namespace {

constexpr int most_names = 100;

class WholeFile final : public ByteSink {
 public:
  explicit WholeFile(std::filesystem::path path) : path_(std::move(path)) { create(); }
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile() override {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  void write(std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) fail("cannot write");
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  void finish() override {
    if (::fsync(descriptor_) != 0) fail("cannot sync");
    if (::close(std::exchange(descriptor_, -1)) != 0) fail("cannot close");
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot rename the temporary file");
    temporary_.clear();
    sync_directory();
  }

 private:
  /// The process number keeps programs apart that write in one directory at the same time; O_EXCL decides.
  void create() {
    const std::string stem = ".cdfr-" + std::to_string(::getpid()) + "-";
    for (int attempt = 0; attempt < most_names && descriptor_ < 0; ++attempt) {
      const auto name = path_.parent_path() / (stem + std::to_string(attempt) + ".part");
      descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
      if (descriptor_ >= 0) {
        temporary_ = name;
      } else if (errno != EEXIST) {
        break;
      }
    }
    if (descriptor_ < 0) fail("cannot create a file in its directory");
  }

  /// So that the new name outlives a power cut too; file systems without a sync for directories do without.
  void sync_directory() const {
    const auto parent = path_.has_parent_path() ? path_.parent_path() : std::filesystem::path(".");
    const int directory = ::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0) return;
    ::fsync(directory);
    ::close(directory);
  }

  [[noreturn]] void fail(const char* what) const {
    stop_failed(path_, std::string(what) + ": " + std::generic_category().message(errno));
  }

  std::filesystem::path path_;
  std::filesystem::path temporary_;  ///< empty once renamed
  int descriptor_ = -1;
};

class StandardOutput final : public ByteSink {
 public:
  void write(std::string_view bytes) override {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) fail();
  }
  void finish() override {
    if (std::fflush(stdout) != 0) fail();
  }

 private:
  [[noreturn]] static void fail() {
    stop_failed("standard output", "cannot write: " + std::generic_category().message(errno));
  }
};

}  // namespace

std::unique_ptr<ByteSink> whole_file(const std::filesystem::path& path) {
  return std::make_unique<WholeFile>(path);
}

std::unique_ptr<ByteSink> standard_output() { return std::make_unique<StandardOutput>(); }

void print_text(std::string_view text) {
  StandardOutput output;
  output.write(text);
  output.finish();
}

}  // namespace cdfr::command
