/// Where a build keeps what it has done, beside its output, so that it can go on after a kill.
#pragma once

#include <filesystem>

#include "cdfr/core/result.h"

namespace cdfr {

/// Ours alone while this lives: locked. Move-only.
class WorkFolder {
 public:
  /// "OUTPUT.work", made with mode 0700 or found as somebody's interrupted work. Errors: file_write, if it is
  /// no folder of ours (a symbolic link, another owner), or another build to this output is running.
  static Result<WorkFolder> open(const std::filesystem::path& output);

  WorkFolder(WorkFolder&& other) noexcept;
  WorkFolder& operator=(WorkFolder&& other) noexcept;
  ~WorkFolder();

  const std::filesystem::path& path() const noexcept { return path_; }
  /// Removes what lies in it but the lock.
  void clear() const;
  /// Removes it with all that lies in it.
  void remove();

 private:
  WorkFolder() = default;

  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace cdfr
