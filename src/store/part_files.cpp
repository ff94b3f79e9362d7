#include "store/part_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "field/build_field.h"

namespace cdfr {
namespace {

constexpr std::array<const char*, 7> names{"nodes", "leaves", "entries", "whole", "place", "known", "near"};
constexpr std::array<std::size_t, 7> element_size{
    sizeof(TreeNode),      sizeof(LeafRecord),          sizeof(Entry),        sizeof(std::int32_t),
    sizeof(std::uint32_t), sizeof(LeafWindings::Known), sizeof(std::uint32_t)};

Error failure(const char* what) {
  return {Code::file_write, 0, std::string(what) + ": " + std::generic_category().message(errno)};
}

}  // namespace

/// Of one block. Level rows are cells, leaves, entries_in, entries_pruned, entries_kept.
struct PartFiles::Record {
  std::uint64_t key = 0;
  std::array<std::uint64_t, part_count> counts{};
  std::array<std::uint64_t, part_count> hashes{};
  std::array<std::array<std::uint64_t, 5>, deepest_level + 1> levels{};
  std::uint64_t level_count = 0;
  std::uint64_t hash = 0;  ///< of all before it

  std::uint64_t own_hash() const noexcept { return XXH64(this, offsetof(Record, hash), 0); }
};

PartFiles::File::File(File&& other) noexcept
    : descriptor(std::exchange(other.descriptor, -1)), size(other.size) {}
PartFiles::File& PartFiles::File::operator=(File&& other) noexcept {
  std::swap(descriptor, other.descriptor);
  std::swap(size, other.size);
  return *this;
}
PartFiles::File::~File() {
  if (descriptor >= 0) ::close(descriptor);
}

Result<PartFiles> PartFiles::open(const std::filesystem::path& folder) {
  PartFiles parts;
  parts.folder_ = folder;
  const auto open = [&](const char* name) {
    return File(::open((folder / name).c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600));
  };
  for (std::size_t i = 0; i < part_count; ++i) {
    parts.files_[i] = open(names[i]);
    if (parts.files_[i].descriptor < 0) return failure("cannot open a file of its work folder");
  }
  parts.log_ = open("blocks");
  if (parts.log_.descriptor < 0) return failure("cannot open a file of its work folder");
  if (Result<void> read = parts.read_log(); !read) return read.error();
  return parts;
}

/// Keeps what is whole; the files end where that does.
Result<void> PartFiles::read_log() {
  const Result<MappedFile> log = MappedFile::open(folder_ / "blocks");
  if (!log) return log.error();
  std::array<std::span<const std::byte>, part_count> bytes;
  std::vector<MappedFile> maps;
  for (std::size_t i = 0; i < part_count; ++i) {
    Result<MappedFile> map = MappedFile::open(folder_ / names[i]);
    if (!map) return map.error();
    bytes[i] = map->bytes();
    maps.push_back(std::move(*map));
  }
  for (std::size_t at = 0; at + sizeof(Record) <= log->bytes().size(); at += sizeof(Record)) {
    Record record;
    std::memcpy(&record, log->bytes().data() + at, sizeof record);
    bool good = record.hash == record.own_hash() && record.level_count <= record.levels.size();
    for (std::size_t i = 0; i < part_count && good; ++i) {
      const std::uint64_t size = record.counts[i] * element_size[i];
      good = size <= bytes[i].size() - files_[i].size &&
             XXH64(bytes[i].data() + files_[i].size, size, 0) == record.hashes[i];
    }
    if (!good) break;
    std::vector<LevelStats> levels;
    for (std::size_t l = 0; l < record.level_count; ++l) {
      const auto& row = record.levels[l];
      levels.push_back({static_cast<int>(l), row[0], row[1], row[2], row[3], row[4], 0});
    }
    add_levels(levels_, levels);
    add_start(record);
    for (std::size_t i = 0; i < part_count; ++i) files_[i].size += record.counts[i] * element_size[i];
    log_.size += sizeof record;
  }
  const auto cut = [](const File& file) {
    return ::ftruncate(file.descriptor, static_cast<off_t>(file.size)) == 0;
  };
  for (const File& file : files_) {
    if (!cut(file)) return failure("cannot cut a file of its work folder");
  }
  return cut(log_) ? Result<void>() : failure("cannot cut a file of its work folder");
}

void PartFiles::add_start(const Record& record) {
  const auto& counts = record.counts;
  starts_.back().key = record.key;
  starts_.push_back(starts_.back().next(counts[nodes], counts[leaves], counts[entries]));
}

Result<void> PartFiles::write(File& file, const void* data, std::size_t bytes) {
  const auto* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t done = ::pwrite(file.descriptor, from, bytes, static_cast<off_t>(file.size));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) {
      if (done == 0) errno = ENOSPC;
      return failure("cannot write to its work folder");
    }
    from += done;
    file.size += static_cast<std::uint64_t>(done);
    bytes -= static_cast<std::size_t>(done);
  }
  return {};
}

Result<void> PartFiles::append(FinishedBlock finished) {
  LeafWindingLists& w = finished.windings;
  move_behind(w, files_[known].size / element_size[known], files_[near].size / element_size[near]);
  Record record;
  const Block& block = finished.block;
  record.key = block.key;
  Result<void> done;
  const auto put = [&](Part part, const auto& array) {
    record.counts[part] = array.size();
    const std::size_t bytes = array.size() * element_size[part];
    record.hashes[part] = XXH64(array.data(), bytes, 0);
    if (done) done = write(files_[part], array.data(), bytes);
  };
  put(nodes, block.nodes);
  put(leaves, block.leaves);
  put(entries, block.entries);
  put(whole, w.whole);
  put(place, w.place);
  put(known, w.known);
  put(near, w.near);
  record.level_count = finished.levels.size();
  for (std::size_t l = 0; l < finished.levels.size(); ++l) {
    const LevelStats& s = finished.levels[l];
    record.levels[l] = {s.cells, s.leaves, s.entries_in, s.entries_pruned, s.entries_kept};
  }
  record.hash = record.own_hash();
  if (done) done = write(log_, &record, sizeof record);
  if (!done) return done;
  add_levels(levels_, finished.levels);
  add_start(record);
  return {};
}

template <class T>
Result<void> PartFiles::map(Part part, Array<T>& array) const {
  Result<MappedFile> file = MappedFile::open(folder_ / names[part]);
  if (!file) return file.error();
  const auto kept = std::make_shared<const MappedFile>(std::move(*file));
  const std::span<const std::byte> bytes = kept->bytes();
  array = Array<T>(reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T), kept);
  return {};
}

Result<void> PartFiles::give(FieldData& field, Octree upper, const Scratch* scratch) {
  Result<void> done;
  if (files_[place].size > 0) {
    const LeafWindings::Known end{
        0, {}, 0, static_cast<std::uint32_t>(files_[near].size / sizeof(std::uint32_t))};
    done = write(files_[known], &end, sizeof end);
  }
  const auto get = [&](Part part, auto& array) {
    if (done) done = map(part, array);
  };
  LeafWindings& w = field.leaf_windings;
  get(nodes, upper.nodes);
  get(leaves, upper.leaves);
  get(entries, upper.entries);
  get(whole, w.whole);
  get(place, w.place);
  get(known, w.known);
  get(near, w.near);
  if (!done) return done;
  upper.levels = levels_;
  upper.starts = std::move(starts_);
  field.tree = std::move(upper);
  field.index = LeafIndex(field.tree, scratch);
  return {};
}

}  // namespace cdfr
