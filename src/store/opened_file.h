/// A file whose head and directory are good.
#pragma once

#include <filesystem>
#include <memory>

#include "cdfr/core/result.h"
#include "cdfr/store/store.h"
#include "core/guarded_map.h"
#include "store/file_check.h"
#include "store/format.h"

namespace cdfr {

struct OpenedFile {
  std::shared_ptr<GuardedMap> map;  ///< not guarded yet
  format::Head head;
  format::Counts counts;                   ///< zero if packed
  std::shared_ptr<const FileCheck> check;  ///< none if packed

  /// Errors: file_open, file_format, file_version, file_truncated.
  static Result<OpenedFile> open(const std::filesystem::path& path);
};

/// load() of a file whose octree has no block yet: part of a build that was interrupted.
Result<StoredField> load_prepared(const std::filesystem::path& path);

}  // namespace cdfr
