/// A field's arrays as a file.
#pragma once

#include <filesystem>

#include "cdfr/core/result.h"
#include "cdfr/store/store.h"
#include "core/progress.h"
#include "store/arrays.h"

namespace cdfr {

/// Whole or not at all. Polls the progress. `map` is the file that the arrays lie in, if any. Errors:
/// file_write, cancelled, and the map's.
Result<void> write_field(const Arrays& arrays, const GuardedMap* map, const std::filesystem::path& path,
                         Packing packing, Progress& progress);

}  // namespace cdfr
