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

/// A binary STL has 50 bytes a triangle, other formats seldom less than 24. A triangle takes 84 bytes as
/// mesh, 550 while topology and normals are made and 260 as prepared file; or 260, 100 as parts of the octree
/// and 360 as field.
std::uint64_t disk_for(const std::filesystem::path& mesh) {
  const auto file = MappedFile::open(mesh);
  if (!file) return 0;
  const std::uint64_t triangles = file->bytes().size() / (is_binary_stl(file->bytes()) ? 50 : 24);
  return 32 * mebi + 900 * triangles;
}

}  // namespace cdfr
