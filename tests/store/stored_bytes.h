/// A fresh folder for each test, with saved fields in it as strings of bytes.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "cdfr/store/store.h"
#include "store/seal.h"
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
