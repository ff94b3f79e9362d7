#include "store/block_writer.h"

#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <span>

#include "core/guarded_map.h"

namespace cdfr {
namespace {

constexpr std::size_t block_size = GuardedMap::block_size;
constexpr int packing_level = 3;

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) noexcept {
  return std::as_bytes(std::span<const T>(values));
}

}  // namespace

BlockWriter::BlockWriter(WholeFile& file, const format::Head& head, Packing packing)
    : file_(file), packing_(packing), packer_(nullptr, &ZSTD_freeCCtx) {
  block_.reserve(block_size);
  if (packing_ == Packing::none) return;
  packer_.reset(ZSTD_createCCtx());
  packed_.resize(ZSTD_compressBound(block_size));
  format::Head outer = head;
  outer.packing = 1;
  outer.hash = XXH64(&outer, format::hashed_head, 0);
  done_ = file_.write(std::as_bytes(std::span(&outer, 1)));
  sizes_at_ = file_.size();
  // The sizes and their hash come when they are known.
  packed_sizes_.assign((head.file_size + block_size - 1) / block_size + 1, 0);
  if (done_) done_ = file_.write(bytes_of(packed_sizes_));
  packed_sizes_.clear();
}

BlockWriter::~BlockWriter() = default;

void BlockWriter::put_block() {
  if (is_data_) sums_.push_back(XXH64(block_.data(), block_.size(), 0));
  if (done_ && packing_ == Packing::none) done_ = file_.write(block_);
  if (done_ && packing_ == Packing::zstd) {
    const std::size_t size = ZSTD_compressCCtx(packer_.get(), packed_.data(), packed_.size(), block_.data(),
                                               block_.size(), packing_level);
    assert(!ZSTD_isError(size));
    packed_sizes_.push_back(size);
    done_ = file_.write({packed_.data(), size});
  }
  block_.clear();
}

void BlockWriter::bytes(const void* data, std::size_t size) {
  const auto* from = static_cast<const std::byte*>(data);
  size_ += size;
  while (size > 0) {
    const std::size_t some = std::min(size, block_size - block_.size());
    block_.insert(block_.end(), from, from + some);
    from += some;
    size -= some;
    if (block_.size() == block_size) put_block();
  }
}

void BlockWriter::align() {
  constexpr std::array<char, format::alignment> zeros{};
  bytes(zeros.data(), (format::alignment - size_ % format::alignment) % format::alignment);
}

std::vector<std::uint64_t> BlockWriter::end_of_data() {
  if (!block_.empty()) sums_.push_back(XXH64(block_.data(), block_.size(), 0));
  is_data_ = false;
  return sums_;
}

Result<void> BlockWriter::finish() {
  if (!block_.empty()) put_block();
  if (done_ && packing_ == Packing::zstd) {
    packed_sizes_.push_back(XXH64(packed_sizes_.data(), packed_sizes_.size() * sizeof(std::uint64_t), 0));
    done_ = file_.write_at(sizes_at_, bytes_of(packed_sizes_));
  }
  return done_;
}

}  // namespace cdfr
