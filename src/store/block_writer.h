/// Bytes of a field's file, block by block: summed up, packed if that is asked for, written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "cdfr/store/store.h"
#include "core/whole_file.h"
#include "store/format.h"

struct ZSTD_CCtx_s;

namespace cdfr {

class BlockWriter {
 public:
  /// `head` is what the unpacked file begins with; it goes through bytes() like all the rest.
  BlockWriter(WholeFile& file, const format::Head& head, Packing packing);
  ~BlockWriter();
  BlockWriter(const BlockWriter&) = delete;
  BlockWriter& operator=(const BlockWriter&) = delete;

  void bytes(const void* data, std::size_t size);
  void align();
  /// The sums of all blocks so far, the last one as it is. What follows is not summed up.
  std::vector<std::uint64_t> end_of_data();
  /// The first error. The file is not finished.
  Result<void> finish();

 private:
  void put_block();

  WholeFile& file_;
  Packing packing_;
  std::vector<std::byte> block_;
  std::uint64_t size_ = 0;
  bool is_data_ = true;
  std::vector<std::uint64_t> sums_, packed_sizes_;
  std::uint64_t sizes_at_ = 0;
  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> packer_;
  std::vector<std::byte> packed_;
  Result<void> done_;
};

}  // namespace cdfr
