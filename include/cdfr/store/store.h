/// A field as a file.
#pragma once

#include <filesystem>
#include <string>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/field/field.h"

namespace cdfr {

/// What a file says beside the field itself.
struct StoredField {
  Field field;
  std::string unit;  ///< the label given at build, or empty
};

/// Written to a temporary file beside it, synced, renamed: the file is whole or not there. Errors: file_write.
CDFR_API Result<void> save(const Field& field, const std::filesystem::path& path, const std::string& unit = "");
/// Errors: file_open, file_format, file_version, file_truncated. Every index and size is checked.
CDFR_API Result<StoredField> load(const std::filesystem::path& path);

}  // namespace cdfr
