#include "core/mapped_file.h"

#include <sys/mman.h>

#include <utility>

#include "core/regular_file.h"

namespace cdfr {

Result<MappedFile> MappedFile::open(const std::filesystem::path& path) {
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return file.error();
  if (file->size() == 0) return MappedFile({});
  void* memory = ::mmap(nullptr, file->size(), PROT_READ, MAP_PRIVATE, file->descriptor(), 0);
  if (memory == MAP_FAILED) return RegularFile::error("cannot map");
  ::madvise(memory, file->size(), MADV_SEQUENTIAL);  // advice only: its failure changes nothing
  return MappedFile({static_cast<const std::byte*>(memory), file->size()});
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  if (this != &other) {
    close();
    bytes_ = std::exchange(other.bytes_, {});
  }
  return *this;
}

MappedFile::~MappedFile() { close(); }

void MappedFile::close() noexcept {
  // munmap takes a mutable pointer although it does not write.
  if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
  bytes_ = {};
}

}  // namespace cdfr
