#include "store/write_field.h"

#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <type_traits>
#include <vector>

#include "core/whole_file.h"
#include "store/block_writer.h"
#include "store/format.h"

namespace cdfr {
namespace {

static_assert(std::endian::native == std::endian::little, "a .cdfr file is written as it lies in memory");

/// So much is written between two polls: some milliseconds.
constexpr std::size_t piece = std::size_t{1} << 22;

format::Head head_of(const format::Counts& counts) noexcept {
  format::Head head;
  head.magic = format::magic;
  head.version = format::version;
  head.sections = format::section_count;
  head.file_size = format::Places(counts).file_size();
  head.directory_hash = XXH64(counts.data(), sizeof counts, 0);
  head.hash = XXH64(&head, format::hashed_head, 0);
  return head;
}

}  // namespace

Result<void> write_field(const Arrays& arrays, const GuardedMap* map, const std::filesystem::path& path,
                         Packing packing, Progress& progress) {
  const auto status = [&] { return map == nullptr ? Result<void>() : map->status(); };
  if (Result<void> sound = status(); !sound) return sound;
  format::Counts counts{};
  for_each_array(arrays, [&](format::Section section, const auto& array) { counts[section] = array.size(); });
  const std::uint64_t data_end = format::Places(counts).at[format::checksums];
  counts[format::checksums] = (data_end + GuardedMap::block_size - 1) / GuardedMap::block_size;
  Result<WholeFile> file = WholeFile::create(path);
  if (!file) return file.error();
  const format::Head head = head_of(counts);
  BlockWriter writer(*file, head, packing);
  writer.bytes(&head, sizeof head);
  writer.bytes(counts.data(), sizeof counts);
  writer.align();
  for_each_array(arrays, [&]<class T>(format::Section, const Array<T>& array) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto bytes = std::as_bytes(std::span<const T>(array));
    for (std::size_t at = 0; at < bytes.size() && progress.poll(); at += piece)
      writer.bytes(bytes.data() + at, std::min(piece, bytes.size() - at));
    writer.align();
  });
  const std::vector<std::uint64_t> sums = writer.end_of_data();
  writer.bytes(sums.data(), sums.size() * sizeof(std::uint64_t));
  writer.align();
  if (progress.cancelled()) return Progress::error();
  if (Result<void> written = writer.finish(); !written) return written;
  if (Result<void> sound = status(); !sound) return sound;
  return file->finish();
}

}  // namespace cdfr
