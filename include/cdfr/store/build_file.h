/// A field built into a file, in bounded memory, by work that goes on where it was interrupted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/octree/options.h"
#include "cdfr/store/store.h"

namespace cdfr {

struct FileBuildOptions {
  BuildOptions build;
  std::string unit;
  bool flip = false;  ///< turn the mesh inside out first
  Packing packing = Packing::none;
  /// Bytes of anonymous memory that the work may take at its peak. What does not fit lies in files of the
  /// work folder, which the kernel pages in and out. 0: as much as it likes.
  std::uint64_t memory = 0;
  bool fresh = false;  ///< do not go on with interrupted work
};

struct FileBuildReport {
  std::uint64_t blocks = 0;       ///< of the octree
  std::uint64_t blocks_kept = 0;  ///< of interrupted work
};

/// The file that save() writes of Field::build of the mesh, to the last byte, whatever the memory, the
/// threads and the interruptions. Keeps what is done in the folder "OUTPUT.work" beside it (mode 0700,
/// locked), and goes on from there if it finds work for the same mesh, options and version; removes it at the
/// end. A tick that cancels, or a kill, leaves the old output and the folder.
///
/// Errors: read_mesh's and Field::build's; bad_option if the memory is less than the work needs, with the
/// least that works; file_write if another build to that output is running, or the disk has less room than
/// the work needs.
CDFR_API Result<FileBuildReport> build_file(const std::filesystem::path& mesh,
                                            const std::filesystem::path& output,
                                            const FileBuildOptions& options = {}, const Run& run = {});

}  // namespace cdfr
