/// A fresh folder for each test, with saved fields in it as strings of bytes.
#pragma once

#include <gtest/gtest.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "cdfr/store/store.h"
#include "core/guarded_map.h"
#include "store/format.h"
#include "support/scratch.h"

namespace cdfr {

class StoreTest : public ScratchTest {
 protected:
  std::filesystem::path file(const char* name = "field.cdfr") const { return folder() / name; }
  std::size_t file_count() const { return names().size(); }
  static std::string bytes_of(const std::filesystem::path& path) { return text_of(path); }

  /// In place where the size allows: thousands of variants of a file need not be thousands of files.
  static void put_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::error_code missing;
    const bool fits = std::filesystem::file_size(path, missing) == bytes.size() && !missing;
    std::fstream(path, std::ios::binary | std::ios::out | (fits ? std::ios::in : std::ios::trunc)) << bytes;
  }
  std::string saved(const Field& field, const std::string& unit = "") const {
    save(field, file(), unit).value();
    return bytes_of(file());
  }
  /// Gives bytes, of whatever content, the checksums that fit them where they have room for any.
  static void seal(std::string& bytes) {
    format::Head head;
    format::Counts counts;
    if (bytes.size() < format::first_section) return;
    std::memcpy(&counts, bytes.data() + sizeof head, sizeof counts);
    std::memcpy(&head, bytes.data(), sizeof head);
    head.directory_hash = XXH64(&counts, sizeof counts, 0);
    head.hash = XXH64(&head, format::hashed_head, 0);
    std::memcpy(bytes.data(), &head, sizeof head);
    for (std::size_t i = 0; i < format::section_count; ++i) {
      if (counts[i] > bytes.size()) return;
    }
    const format::Places places(counts);
    if (places.file_size() != bytes.size()) return;
    const std::uint64_t end = places.at[format::checksums];
    for (std::uint64_t i = 0; i < counts[format::checksums] && i * GuardedMap::block_size < end; ++i) {
      const std::uint64_t first = i * GuardedMap::block_size;
      const std::uint64_t sum =
          XXH64(bytes.data() + first, std::min<std::uint64_t>(end - first, GuardedMap::block_size), 0);
      std::memcpy(bytes.data() + end + 8 * i, &sum, sizeof sum);
    }
  }
  /// What load says of these bytes; fails if it takes them.
  Code refusal_of(const std::string& bytes) const {
    put_bytes(file("bad.cdfr"), bytes);
    return refusal_at(file("bad.cdfr"));
  }
  static Code refusal_at(const std::filesystem::path& path) {
    const Result<StoredField> loaded = load(path);
    EXPECT_FALSE(loaded);
    if (loaded) return Code{};
    EXPECT_FALSE(loaded.error().text.empty());
    EXPECT_EQ(loaded.error().text.find('\n'), std::string::npos);
    return loaded.error().code;
  }
};

}  // namespace cdfr
