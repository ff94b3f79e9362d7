/// A field as a file.
#pragma once

#include <filesystem>
#include <string>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/field/field.h"

namespace cdfr {

/// How a file's bytes are kept.
enum class Packing {
  none,  ///< as in memory: read by mapping it
  zstd,  ///< smaller, for archives: unpacked into memory whole when it is read
};

/// What a file says beside the field itself.
struct StoredField {
  Field field;
  std::string unit;  ///< the label given at build, or empty
};

/// Written to a temporary file beside it, synced, renamed: the file is whole or not there. Errors:
/// file_write; and the field's own status(), if it came from a file; cancelled.
CDFR_API Result<void> save(const Field& field, const std::filesystem::path& path,
                           const std::string& unit = "", Packing packing = Packing::none,
                           const Run& run = {});

/// Maps the file and looks at its head alone: O(blocks), whatever its size. The rest is checked block by
/// block when a query first reads it (Field::status). Errors: file_open, file_format, file_version,
/// file_truncated, each with the byte. A packed file is checked whole. Installs a handler for SIGSEGV and
/// SIGBUS (core/guarded_map.h).
CDFR_API Result<StoredField> load(const std::filesystem::path& path);

/// Is the file what a build of its mesh with its options gives, to the last bit? All checksums, then the
/// build again: its time, and memory for another such field. Not seen: other patches and another unit.
/// Errors: load's, with section and element; cancelled.
CDFR_API Result<void> verify(const std::filesystem::path& path, const Run& run = {});

}  // namespace cdfr
