#include "store/unpacked_file.h"

#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "core/guarded_map.h"

namespace cdfr {

Result<Large<Aligned>> unpacked(std::span<const std::byte> packed, std::uint64_t size) {
  constexpr std::size_t block_size = GuardedMap::block_size;
  const auto refusal = [](Code code, std::uint64_t where, const std::string& what) {
    return Error{code, where, what + " at byte " + std::to_string(where)};
  };
  // zstd cannot make less than a few bytes of a block, so a head cannot ask for memory that the file does not
  // pay for.
  const std::uint64_t blocks = size / block_size + (size % block_size != 0);
  const std::uint64_t table = (blocks + 1) * sizeof(std::uint64_t);
  if (blocks > packed.size() / sizeof(std::uint64_t) || sizeof(format::Head) + table > packed.size())
    return refusal(Code::file_truncated, packed.size(), "packed file ends in its sizes");
  std::vector<std::uint64_t> sizes(blocks + 1);
  std::memcpy(sizes.data(), packed.data() + sizeof(format::Head), table);
  if (sizes.back() != XXH64(sizes.data(), table - sizeof(std::uint64_t), 0))
    return refusal(Code::file_format, sizeof(format::Head),
                   "sizes of packed blocks: checksum does not match");
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> unpacker(ZSTD_createDCtx(), &ZSTD_freeDCtx);
  Large<Aligned> memory((size + sizeof(Aligned) - 1) / sizeof(Aligned));
  auto* into = reinterpret_cast<std::byte*>(memory.data());
  std::uint64_t at = sizeof(format::Head) + table;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::size_t wanted = std::min<std::uint64_t>(block_size, size - i * block_size);
    if (sizes[i] > packed.size() - at)
      return refusal(Code::file_truncated, packed.size(), "packed file ends in a block");
    const std::size_t got =
        ZSTD_decompressDCtx(unpacker.get(), into + i * block_size, wanted, packed.data() + at, sizes[i]);
    if (got != wanted) return refusal(Code::file_format, at, "packed block: damaged");
    at += sizes[i];
  }
  if (at != packed.size()) return refusal(Code::file_format, at, "bytes after the last packed block");
  return memory;
}

}  // namespace cdfr
