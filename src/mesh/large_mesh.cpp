#include "mesh/large_mesh.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "cdfr/mesh/flip.h"
#include "core/mapped_file.h"
#include "mesh/flip_triangles.h"
#include "mesh/readers.h"
#include "mesh/stl_binary.h"

namespace cdfr {
namespace {

/// Triangles between two looks at the progress: 3 MB of an STL, a few milliseconds, a tenth of a second where
/// disks are slow.
constexpr std::size_t piece = std::size_t{1} << 16;

Result<LargeMesh> stream_stl(std::span<const std::byte> bytes, const Scratch& scratch, bool flipped,
                             Progress& progress) {
  const Result<std::uint64_t> count = count_stl_binary(bytes);
  if (!count) return count.error();
  Large<Triangle> triangles(&scratch);
  Large<Vec3> vertices(&scratch);
  triangles.reserve(*count);
  vertices.reserve(3 * *count);
  for (std::size_t first = 0; first < *count; first += piece) {
    if (!progress.poll()) return Progress::error();
    const std::size_t end = std::min<std::size_t>(first + piece, *count);
    triangles.resize(end);
    vertices.resize(3 * end);
    const auto read = std::span(triangles).subspan(first);
    if (auto done = read_stl_triangles(bytes, first, read, std::span(vertices).subspan(3 * first)); !done)
      return done.error();
    if (flipped) flip_triangles(read);
  }
  return LargeMesh{std::move(vertices), std::move(triangles), {}, {}};
}

/// Empties the vector. What is copied when the progress is cancelled is of no use.
template <class T>
Array<T> moved_out(std::vector<T>& values, const Scratch& scratch, Progress& progress) {
  const std::vector<T> from = std::exchange(values, {});
  Large<T> to(&scratch);
  to.reserve(from.size());
  for (std::size_t first = 0; first < from.size() && progress.poll(); first += piece) {
    const auto part = std::span(from).subspan(first, std::min(piece, from.size() - first));
    to.insert(to.end(), part.begin(), part.end());
  }
  return to;
}

}  // namespace

Result<LargeMesh> read_large_mesh(const std::filesystem::path& path, const Scratch& scratch, bool flipped,
                                  Progress& progress) {
  const auto file = MappedFile::open(path);
  if (!file) return file.error();
  const MeshReader reader = reader_of(file->bytes(), path.extension().string());
  if (reader == read_stl_binary) return stream_stl(file->bytes(), scratch, flipped, progress);
  Result<Mesh> mesh = reader(file->bytes());
  if (!mesh) return mesh.error();
  if (flipped) flip(*mesh);
  LargeMesh large;
  large.vertices = moved_out(mesh->vertices, scratch, progress);
  large.triangles = moved_out(mesh->triangles, scratch, progress);
  large.patches = moved_out(mesh->patches, scratch, progress);
  large.patch_names = std::move(mesh->patch_names);
  if (progress.cancelled()) return Progress::error();
  return large;
}

}  // namespace cdfr
