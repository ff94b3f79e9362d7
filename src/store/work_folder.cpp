#include "store/work_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace cdfr {
namespace {

constexpr const char* lock_name = "lock";

Error failure(const std::string& what, int number) {
  return {Code::file_write, 0, what + ": " + std::generic_category().message(number)};
}

}  // namespace

Result<WorkFolder> WorkFolder::open(const std::filesystem::path& output) {
  WorkFolder work;
  work.path_ = output;
  work.path_ += ".work";
  // Who finishes removes the folder; who had opened it just before tries again.
  for (int attempt = 0; attempt < 100; ++attempt) {
    if (::mkdir(work.path_.c_str(), 0700) != 0 && errno != EEXIST)
      return failure("cannot make its work folder", errno);
    const int folder = ::open(work.path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0 && errno == ENOENT) continue;
    if (folder < 0)
      return failure("its work folder " + work.path_.filename().string() + " is not usable", errno);
    struct stat status {};
    const bool ours = ::fstat(folder, &status) == 0 && status.st_uid == ::geteuid();
    if (ours) work.lock_ = ::openat(folder, lock_name, O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600);
    const int opening = errno;
    ::close(folder);
    if (!ours) return Error{Code::file_write, 0, "its work folder belongs to someone else"};
    if (work.lock_ < 0 && opening == ENOENT) continue;
    if (work.lock_ < 0) return failure("cannot lock its work folder", opening);
    if (::flock(work.lock_, LOCK_EX | LOCK_NB) != 0)
      return Error{Code::file_write, 0, "another build to this file is running"};
    // The lock may have gone with the folder while we waited to open it.
    struct stat named {
    }, held{};
    const std::string name = (work.path_ / lock_name).string();
    if (::stat(name.c_str(), &named) == 0 && ::fstat(work.lock_, &held) == 0 && named.st_ino == held.st_ino)
      return work;
    ::close(std::exchange(work.lock_, -1));
  }
  return Error{Code::file_write, 0, "its work folder comes and goes"};
}

WorkFolder::WorkFolder(WorkFolder&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

WorkFolder& WorkFolder::operator=(WorkFolder&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(lock_, other.lock_);
  return *this;
}

WorkFolder::~WorkFolder() {
  if (lock_ >= 0) ::close(lock_);
}

void WorkFolder::clear() const {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(path_, ignored)) {
    if (entry.path().filename() != lock_name) std::filesystem::remove_all(entry.path(), ignored);
  }
}

void WorkFolder::remove() {
  std::error_code ignored;
  clear();
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace cdfr
