#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "cdfr/store/store.h"
#include "core/guarded_map.h"
#include "field/field_data.h"
#include "store/arrays.h"
#include "store/file_check.h"
#include "store/format.h"
#include "store/opened_file.h"
#include "store/unpacked_file.h"

namespace cdfr {
namespace {

using Bytes = std::span<const std::byte>;

Error refusal(std::uint64_t where, std::string what) {
  return {Code::file_format, where, std::move(what) + " at byte " + std::to_string(where)};
}

Error too_short(std::uint64_t size) {
  return {Code::file_truncated, size, "file ends in its head at byte " + std::to_string(size)};
}

template <class T>
T value_at(Bytes bytes, std::uint64_t offset) {
  T value;
  std::memcpy(static_cast<void*>(&value), bytes.data() + offset, sizeof value);
  return value;
}

/// Of a file of either packing.
Result<format::Head> checked_head(Bytes bytes) {
  if (bytes.size() < format::magic.size() ||
      std::memcmp(bytes.data(), format::magic.data(), format::magic.size()) != 0) {
    return refusal(0, "not a .cdfr file: no magic");
  }
  if (bytes.size() < sizeof(format::Head)) return too_short(bytes.size());
  const auto head = value_at<format::Head>(bytes, 0);
  if (head.version != format::version) {
    return Error{Code::file_version, 8,
                 "version " + std::to_string(head.version) + "; this program knows " +
                     std::to_string(format::version)};
  }
  if (head.hash != XXH64(&head, format::hashed_head, 0)) return refusal(40, "head: checksum does not match");
  if (head.packing > 1 || head.sections != format::section_count)
    return refusal(12, "head: bad packing or sections");
  return head;
}

/// After this every section lies within the file.
Result<format::Counts> checked_counts(Bytes bytes, const format::Head& head) {
  if (head.file_size != bytes.size()) {
    return Error{Code::file_truncated, bytes.size(),
                 "file has " + std::to_string(bytes.size()) + " bytes, its head says " +
                     std::to_string(head.file_size)};
  }
  if (bytes.size() < format::first_section) return too_short(bytes.size());
  const auto counts = value_at<format::Counts>(bytes, sizeof head);
  if (head.directory_hash != XXH64(&counts, sizeof counts, 0))
    return refusal(sizeof head, "directory: checksum does not match");
  bool fits = true;
  for (std::size_t i = 0; i < format::section_count; ++i)
    fits = fits && counts[i] <= bytes.size() / format::element_size[i];
  if (!fits || format::Places(counts).file_size() != bytes.size())
    return refusal(sizeof head, "directory: counts do not fit the file");
  const std::uint64_t data_end = format::Places(counts).at[format::checksums];
  if (counts[format::checksums] != (data_end + GuardedMap::block_size - 1) / GuardedMap::block_size)
    return refusal(sizeof head, "directory: counts of checksums do not fit");
  // What no checksum covers.
  const auto tail = bytes.subspan(data_end + counts[format::checksums] * sizeof(std::uint64_t));
  if (std::any_of(tail.begin(), tail.end(), [](std::byte b) { return b != std::byte{0}; }))
    return refusal(data_end, "checksums: not zero behind them");
  return counts;
}

/// A field, or one whose octree is not built yet.
enum class Stage { built, prepared };

/// One for each triangle, group, node or leaf, where there should be.
bool add_up(const format::Counts& c, const format::Settings& s, const MeshReport& report, Stage stage) {
  const std::uint64_t triangles = c[format::triangles], groups = (triangles + group_size - 1) / group_size;
  const std::uint64_t nodes = 2 * groups - 1, leaves = c[format::index_leaves];
  if (triangles == 0 || triangles >= no_index || c[format::records] != triangles ||
      c[format::scan_groups] != groups || c[format::bvh_nodes] != nodes || report.triangles != triangles)
    return false;
  const auto sign = static_cast<Sign>(s.sign);
  if (sign != Sign::none && c[format::vertex_normals] != report.vertices) return false;
  if (sign == Sign::none && c[format::vertex_normals] + c[format::edge_normals] != 0) return false;
  const std::uint64_t cubes = std::uint64_t{s.bricks[0]} * s.bricks[1] * s.bricks[2];
  if (stage == Stage::prepared &&
      c[format::top] + c[format::block_starts] + c[format::block_nodes] + leaves == 0)
    return c[format::winding_nodes] == (sign == Sign::winding && !report.balanced() ? nodes : 0);
  if (leaves == 0 || s.index_level > 16 || c[format::index_grid] != cubes << (3 * s.index_level) ||
      c[format::block_leaves] != leaves || c[format::top] == 0 || c[format::block_starts] < 2)
    return false;
  const bool wound = sign == Sign::winding, open = wound && !report.balanced();
  return c[format::windings] == (wound && !open ? leaves : 0) &&
         c[format::winding_places] == (open ? leaves : 0) && (c[format::known_windings] > 0) == open &&
         c[format::winding_nodes] == (open ? nodes : 0) &&
         c[format::boundary_first] == (open ? groups + 1 : 0) &&
         c[format::boundary_lengths] == (open ? nodes : 0);
}

bool good_settings(const format::Settings& s) {
  int exponent = 0;
  const bool power = std::isfinite(s.edge) && s.edge > 0 && std::frexp(s.edge, &exponent) == 0.5;
  const bool sized = power && s.edge >= 0x1p-240 && s.edge <= 0x1p210;
  if (!sized) return false;
  const double finest = std::ldexp(s.edge, -deepest_level);
  for (const double o : s.origin) {
    const bool placed = std::isfinite(o) && std::fabs(o) <= 0x1p201 && std::fmod(o, finest) == 0 &&
                        std::fabs(o) <= finest * 0x1p53;
    if (!placed) return false;
  }
  for (const std::uint32_t brick : s.bricks) {
    if (brick - 1 >= 8) return false;  // 0 wraps round
  }
  const auto sign = static_cast<Sign>(s.sign), asked = static_cast<Sign>(s.sign_option);
  return s.margin >= 0 && s.margin <= 1 && s.gain > 0 && s.max_triangles_per_leaf >= 1 &&
         s.max_level <= deepest_level && sign != Sign::automatic && sign <= Sign::none &&
         asked <= Sign::none && static_cast<Lists>(s.lists) <= Lists::band &&
         static_cast<Domain>(s.domain) <= Domain::band && s.band >= 0;
}

/// Sections as they lie in `bytes`, kept by `owner`.
Arrays arrays_in(Bytes bytes, const format::Counts& counts, const std::shared_ptr<const void>& owner) {
  const format::Places places(counts);
  Arrays arrays;
  for_each_array(arrays, [&]<class T>(format::Section section, Array<T>& array) {
    if (counts[section] == 0) return;
    const auto* first = reinterpret_cast<const T*>(bytes.data() + places.at[section]);
    array = Array<T>(first, counts[section], owner);
  });
  return arrays;
}

Result<StoredField> field_of(const Arrays& arrays, const format::Counts& counts,
                             std::shared_ptr<const GuardedMap> map, Stage stage) {
  const auto refused = [&](const char* what) -> Error {
    if (map != nullptr && map->failed()) return map->status().error();
    return refusal(format::first_section, what);
  };
  if (counts[format::settings] != 1 || counts[format::report] != 1) return refused("settings: not one");
  if (!good_settings(arrays.settings[0])) return refused("settings: out of range");
  if (counts[format::levels] > deepest_level + 1) return refused("levels: too many");
  if (!add_up(counts, arrays.settings[0], arrays.report[0], stage))
    return refused("directory: counts do not add up");
  FieldData field;
  take_arrays(arrays, field);
  if (map != nullptr && map->failed()) return map->status().error();
  field.map = std::move(map);
  return StoredField{Field(std::make_shared<const FieldData>(std::move(field))),
                     std::string(arrays.unit.begin(), arrays.unit.end())};
}

/// Of an unpacked file that lies in memory.
Result<StoredField> load_whole(const std::shared_ptr<const Large<Aligned>>& memory, std::size_t size) {
  const Bytes bytes = std::as_bytes(std::span(*memory)).first(size);
  const Result<format::Head> head = checked_head(bytes);
  if (!head) return head.error();
  const Result<format::Counts> counts = checked_counts(bytes, *head);
  if (!counts) return counts.error();
  const FileCheck check(bytes, *counts);
  if (const std::size_t bad = check.first_bad(); bad < size)
    return refusal(bad, check.place_text(bad) + ": damaged");
  return field_of(arrays_in(bytes, *counts, memory), *counts, nullptr, Stage::built);
}

}  // namespace

Result<OpenedFile> OpenedFile::open(const std::filesystem::path& path) {
  Result<std::shared_ptr<GuardedMap>> map = GuardedMap::open(path);
  if (!map) return map.error();
  const Bytes bytes = (*map)->open_bytes();
  const Result<format::Head> head = checked_head(bytes);
  if (!head) return head.error();
  if (head->packing == 1) return OpenedFile{std::move(*map), *head, {}, nullptr};
  const Result<format::Counts> counts = checked_counts(bytes, *head);
  if (!counts) return counts.error();
  return OpenedFile{*map, *head, *counts, std::make_shared<const FileCheck>(bytes, *counts)};
}

namespace {

Result<StoredField> load_stage(const std::filesystem::path& path, Stage stage) {
  Result<OpenedFile> file = OpenedFile::open(path);
  if (!file) return file.error();
  if (file->head.packing == 1) {
    Result<Large<Aligned>> memory = unpacked(file->map->open_bytes(), file->head.file_size);
    if (!memory) return memory.error();
    return load_whole(std::make_shared<const Large<Aligned>>(std::move(*memory)), file->head.file_size);
  }
  struct Owner {
    std::shared_ptr<const FileCheck> check;  // outlives the map
    std::shared_ptr<GuardedMap> map;
  };
  const auto owner = std::make_shared<const Owner>(Owner{file->check, file->map});
  const Bytes bytes = file->map->guard(*file->check);
  std::shared_ptr<const GuardedMap> map(owner, file->map.get());
  return field_of(arrays_in(bytes, file->counts, owner), file->counts, std::move(map), stage);
}

}  // namespace

Result<StoredField> load(const std::filesystem::path& path) { return load_stage(path, Stage::built); }

Result<StoredField> load_prepared(const std::filesystem::path& path) {
  return load_stage(path, Stage::prepared);
}

}  // namespace cdfr
