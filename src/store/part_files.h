/// The octree while it is built on disk: one growing file for each of its arrays, and a log of finished
/// blocks.
///
/// A block is appended to each file, then a record to the log: what the block took, and a hash of its bytes.
/// Whoever goes on after a kill keeps the blocks whose records and bytes are whole, and cuts off the rest. So
/// nothing needs to be synced on the way, and a lost page costs no more than the blocks from there on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "cdfr/core/result.h"
#include "core/mapped_file.h"
#include "core/scratch.h"
#include "field/finished_block.h"

namespace cdfr {

class PartFiles {
 public:
  /// Opens or makes the files in the folder and keeps the blocks that are whole. Errors: file_write. O(bytes
  /// there).
  static Result<PartFiles> open(const std::filesystem::path& folder);

  /// Blocks that are there.
  std::size_t size() const noexcept { return starts_.size() - 1; }
  /// Precondition: it follows the last one. Errors: file_write.
  Result<void> append(FinishedBlock block);
  /// Makes the field's octree of all blocks, mapped. `upper` is the part above them. The scratch holds the
  /// index. Errors: file_write, file_open. Call once, last.
  Result<void> give(FieldData& field, Octree upper, const Scratch* scratch);

  PartFiles(PartFiles&&) noexcept = default;
  PartFiles& operator=(PartFiles&&) noexcept = default;

 private:
  enum Part : std::size_t { nodes, leaves, entries, whole, place, known, near, part_count };
  /// A descriptor that closes itself.
  struct File {
    File() = default;
    explicit File(int number) noexcept : descriptor(number) {}
    File(File&& other) noexcept;
    File& operator=(File&& other) noexcept;
    ~File();
    int descriptor = -1;
    std::uint64_t size = 0;
  };
  struct Record;

  PartFiles() = default;
  Result<void> write(File& file, const void* data, std::size_t bytes);
  Result<void> read_log();
  void add_start(const Record& record);
  template <class T>
  Result<void> map(Part part, Array<T>& array) const;

  std::filesystem::path folder_;
  std::array<File, part_count> files_;
  File log_;
  std::vector<BlockStart> starts_{1};  ///< as the octree has them
  std::vector<LevelStats> levels_;
};

}  // namespace cdfr
