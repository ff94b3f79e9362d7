#include "store/work_size.h"

#include <tbb/info.h>

#include <algorithm>

#include "core/mapped_file.h"
#include "mesh/readers.h"

namespace cdfr {
namespace {

constexpr std::uint64_t mebi = std::uint64_t{1} << 20;
/// The program, its libraries and the octree's upper part.
constexpr std::uint64_t fixed = 64 * mebi;
/// A block of 65,536 triangles while it is built, or waits for its turn: lists of one level and its arrays.
/// Measured: 8 to 20 MiB.
constexpr std::uint64_t a_block = 32 * mebi;

}  // namespace

std::uint64_t least_memory(const std::filesystem::path& mesh, unsigned threads) {
  const auto most = static_cast<unsigned>(tbb::info::default_concurrency());
  const unsigned workers = threads == 0 ? most : std::min(threads, most);
  std::uint64_t reading = 0;
  if (const auto file = MappedFile::open(mesh); file && !is_binary_stl(file->bytes())) {
    // The tightest text, "0 0 0" a vertex, grows sixfold; a vector that grows has a copy of half its size.
    reading = 9 * file->bytes().size();
  }
  return fixed + 2 * workers * a_block + reading;
}

/// A binary STL has 50 bytes a triangle, other formats seldom less than 25. Of a triangle, 700 bytes are
/// scratch while topology and tree are made, or 350 the prepared file, 300 the octree's parts and 600 the
/// field.
std::uint64_t disk_for(std::uint64_t mesh_size) { return 32 * mebi + mesh_size / 50 * 1250; }

}  // namespace cdfr
