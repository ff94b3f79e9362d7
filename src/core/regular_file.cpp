#include "core/regular_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <string>
#include <system_error>
#include <utility>

namespace cdfr {

Error RegularFile::error(const char* what) {
  return {Code::file_open, 0, std::string(what) + ": " + std::generic_category().message(errno)};
}

Result<RegularFile> RegularFile::open(const std::filesystem::path& path) {
  // O_NONBLOCK: a FIFO without a writer would hold the open() itself, before fstat can tell what it is.
  RegularFile file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (file.descriptor_ < 0) return error("cannot open");
  if (::fstat(file.descriptor_, &file.status_) != 0) return error("cannot examine");
  if (!S_ISREG(file.status_.st_mode)) return Error{Code::file_open, 0, "is no regular file"};
  if (static_cast<std::uint64_t>(file.status_.st_size) > std::numeric_limits<std::size_t>::max() / 4) {
    return Error{Code::file_open, 0, "is larger than the address space"};
  }
  return file;
}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), status_(other.status_) {}

RegularFile& RegularFile::operator=(RegularFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(status_, other.status_);
  return *this;
}

RegularFile::~RegularFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace cdfr
