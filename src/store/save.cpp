#include <xxhash.h>

#include <bit>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "cdfr/store/store.h"
#include "core/whole_file.h"
#include "store/arrays.h"
#include "store/block_writer.h"
#include "store/format.h"

namespace cdfr {
namespace {

static_assert(std::endian::native == std::endian::little, "a .cdfr file is written as it lies in memory");

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

Result<void> save(const Field& field, const std::filesystem::path& path, const std::string& unit,
                  Packing packing) {
  if (Result<void> sound = field.status(); !sound) return sound;
  const Arrays arrays = arrays_of(field.data(), unit);
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
  for_each_array(arrays, [&](format::Section, const auto& array) {
    using T = typename std::remove_cvref_t<decltype(array)>::value_type;
    static_assert(std::is_trivially_copyable_v<T>);
    writer.bytes(array.data(), array.size() * sizeof(T));
    writer.align();
  });
  const std::vector<std::uint64_t> sums = writer.end_of_data();
  writer.bytes(sums.data(), sums.size() * sizeof(std::uint64_t));
  writer.align();
  if (Result<void> written = writer.finish(); !written) return written;
  if (Result<void> sound = field.status(); !sound) return sound;  // it may have been read on the way
  return file->finish();
}

}  // namespace cdfr
