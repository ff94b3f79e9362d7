#include <cstring>
#include <string>
#include <vector>

#include "cdfr/store/store.h"
#include "core/floating_environment.h"
#include "field/build_field.h"
#include "field/field_data.h"
#include "store/arrays.h"
#include "store/opened_file.h"

namespace cdfr {
namespace {

/// Triangles in the order of their numbers, each with corners of its own, as a build takes them together
/// again.
Mesh mesh_of(const TriangleStore& triangles) {
  Mesh mesh;
  const std::size_t count = triangles.size();
  mesh.vertices.resize(3 * count);
  mesh.triangles.resize(count);
  mesh.patches.resize(count);
  for (std::uint32_t slot = 0; slot < count; ++slot) {
    const std::uint32_t number = triangles.records[slot].number;
    mesh.patches[number] = triangles.exact[slot].patch;
    for (std::uint32_t k = 0; k < 3; ++k) {
      mesh.vertices[3 * std::size_t{number} + k] = triangles.shape(slot).vertices[k];
      mesh.triangles[number][k] = 3 * number + k;
    }
  }
  return mesh;
}

template <class T>
bool same(const Array<T>& a, const Array<T>& b, std::uint64_t& element) {
  element = 0;
  if (a.size() != b.size()) return false;
  for (; element < a.size(); ++element) {
    if (std::memcmp(static_cast<const void*>(&a[element]), static_cast<const void*>(&b[element]),
                    sizeof(T)) != 0)
      return false;
  }
  return true;
}

/// The first element that differs.
Result<void> compared(const Arrays& stored, const Arrays& built) {
  Result<void> result;
  std::vector<const void*> others;
  for_each_array(built, [&](format::Section, const auto& array) { others.push_back(&array); });
  for_each_array(stored, [&]<class T>(format::Section section, const Array<T>& array) {
    std::uint64_t element = 0;
    if (!result || same(array, *static_cast<const Array<T>*>(others[section]), element)) return;
    result = Error{Code::file_format, element,
                   std::string(format::section_name[section]) + ": not what a build gives (element " +
                       std::to_string(element) + ")"};
  });
  return result;
}

}  // namespace

Result<void> verify(const std::filesystem::path& path, const Run& run) {
  const Result<OpenedFile> file = OpenedFile::open(path);
  if (!file) return file.error();
  if (file->check != nullptr) {
    const std::size_t bad = file->check->first_bad();
    if (bad < file->map->open_bytes().size()) {
      return Error{Code::file_format, bad,
                   file->check->place_text(bad) + ": damaged, in the block at byte " + std::to_string(bad)};
    }
  }
  const Result<StoredField> stored = load(path);
  if (!stored) return stored.error();
  const FieldData& field = stored->field.data();
  const Mesh mesh = mesh_of(field.triangles);
  const FloatingEnvironment environment;
  const Result<FieldData> built = build_field(mesh.view(), field.options, run);
  if (!built) return built.error();
  if (Result<void> good = compared(arrays_of(field, stored->unit), arrays_of(*built, stored->unit)); !good)
    return good;
  return stored->field.status();
}

}  // namespace cdfr
