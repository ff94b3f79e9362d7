#include "core/scratch.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <new>
#include <string>
#include <utility>

namespace cdfr {
namespace {

/// The strictest that a type here asks for (ExactTriangle).
constexpr std::align_val_t alignment{128};

}  // namespace

Scratch::Scratch(std::filesystem::path folder) : folder_(std::move(folder)) {}

void* Scratch::allocate(std::size_t bytes) const {
  if (bytes < large) return ::operator new(bytes, alignment);
  int file = ::open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file < 0) {  // not every file system has files without a name
    std::string name = (folder_ / "scratch-XXXXXX").string();
    file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file < 0) throw std::bad_alloc();
    ::unlink(name.c_str());
  }
  const bool claimed = ::posix_fallocate(file, 0, static_cast<off_t>(bytes)) == 0;
  void* block = claimed ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0) : MAP_FAILED;
  ::close(file);
  if (block == MAP_FAILED) throw std::bad_alloc();
  return block;
}

void Scratch::release(void* block, std::size_t bytes) const noexcept {
  if (bytes < large) return ::operator delete(block, alignment);
  ::munmap(block, bytes);
}

}  // namespace cdfr
