#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cdfr/store/store.h"
#include "core/floating_environment.h"
#include "core/mapped_file.h"
#include "field/build_field.h"
#include "field/field_data.h"
#include "store/check.h"
#include "store/format.h"

namespace cdfr {
namespace {

using Bytes = std::span<const std::byte>;

Error refusal(std::uint64_t where, std::string what) {
  return {Code::file_format, where, std::move(what) + " at byte " + std::to_string(where)};
}

template <class T>
T value_at(Bytes bytes, std::uint64_t offset) {
  T value;
  std::memcpy(static_cast<void*>(&value), bytes.data() + offset, sizeof value);
  return value;
}

/// Head, counts and checksum: after this every section lies within the file.
Result<format::Counts> checked_counts(Bytes bytes) {
  constexpr std::uint64_t counts_at = sizeof(format::Head);
  if (bytes.size() < format::magic.size() ||
      std::memcmp(bytes.data(), format::magic.data(), format::magic.size()) != 0) {
    return refusal(0, "not a .cdfr file: no magic");
  }
  if (bytes.size() < counts_at + sizeof(format::Counts) + sizeof(std::uint64_t)) {
    return Error{Code::file_truncated, bytes.size(),
                 "file ends in its head at byte " + std::to_string(bytes.size())};
  }
  const auto head = value_at<format::Head>(bytes, 0);
  if (head.version != format::version) {
    return Error{Code::file_version, 8,
                 "version " + std::to_string(head.version) + "; this program knows " +
                     std::to_string(format::version)};
  }
  if (head.file_size != bytes.size()) {
    return Error{Code::file_truncated, bytes.size(),
                 "file has " + std::to_string(bytes.size()) + " bytes, its head says " +
                     std::to_string(head.file_size)};
  }
  const auto counts = value_at<format::Counts>(bytes, counts_at);
  bool fits = head.sections == format::section_count && counts[format::counts] == format::section_count;
  for (std::size_t i = 0; i < format::section_count; ++i)
    fits = fits && counts[i] <= bytes.size() / format::element_size[i];
  if (!fits || format::file_size(counts) != bytes.size())
    return refusal(counts_at, "section counts do not fit the file");
  const std::uint64_t end = bytes.size() - sizeof(std::uint64_t);
  if (value_at<std::uint64_t>(bytes, end) != XXH64(bytes.data(), end, 0))
    return refusal(end, "checksum does not match");
  return counts;
}

/// Takes sections in order.
class Sections {
 public:
  Sections(Bytes bytes, const format::Counts& counts) : bytes_(bytes), counts_(counts) {}

  template <class T>
  std::vector<T> next() {
    std::vector<T> values(counts_[section_]);
    const std::uint64_t size = values.size() * sizeof(T);
    if (size > 0) std::memcpy(static_cast<void*>(values.data()), bytes_.data() + offset_, size);
    offset_ += format::padded(size);
    ++section_;
    return values;
  }

 private:
  Bytes bytes_;
  const format::Counts& counts_;
  std::uint64_t offset_ = sizeof(format::Head);
  std::size_t section_ = 0;
};

void apply(const format::Settings& s, FieldData& field) {
  field.tree.lattice.origin = {s.origin[0], s.origin[1], s.origin[2]};
  field.tree.lattice.edge = s.edge;
  std::copy(std::begin(s.bricks), std::end(s.bricks), field.tree.lattice.bricks.begin());
  field.options.margin = s.margin;
  field.options.gain = s.gain;
  field.options.max_triangles_per_leaf = static_cast<int>(std::min(s.max_triangles_per_leaf, 0x7fffffffU));
  field.options.max_level = static_cast<int>(std::min(s.max_level, 0x7fffffffU));
  field.options.sign = static_cast<Sign>(s.sign_option);
  field.options.lists = static_cast<Lists>(s.lists);
  field.sign = static_cast<Sign>(s.sign);
}

/// The blocks' own arrays out of the concatenated ones; false if the sizes do not add up.
bool split(Sections& sections, std::vector<Block>& blocks) {
  const auto sizes = sections.next<format::BlockSize>();
  const auto nodes = sections.next<TreeNode>();
  const auto leaves = sections.next<LeafRecord>();
  const auto entries = sections.next<Entry>();
  std::uint64_t node = 0, leaf = 0, entry = 0;
  const auto part = [](const auto& all, std::uint64_t& from, std::uint64_t count, auto& into) {
    if (count > all.size() - from) return false;
    into.assign(all.begin() + static_cast<std::ptrdiff_t>(from),
                all.begin() + static_cast<std::ptrdiff_t>(from + count));
    from += count;
    return true;
  };
  blocks.resize(sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    blocks[i].key = sizes[i].key;
    if (!part(nodes, node, sizes[i].nodes, blocks[i].nodes) ||
        !part(leaves, leaf, sizes[i].leaves, blocks[i].leaves) ||
        !part(entries, entry, sizes[i].entries, blocks[i].entries)) {
      return false;
    }
  }
  return node == nodes.size() && leaf == leaves.size() && entry == entries.size();
}

}  // namespace

Result<StoredField> load(const std::filesystem::path& path) {
  const FloatingEnvironment environment;
  Result<MappedFile> file = MappedFile::open(path);
  if (!file) return file.error();
  const Result<format::Counts> counts = checked_counts(file->bytes());
  if (!counts) return counts.error();
  Sections sections(file->bytes(), *counts);
  sections.next<std::uint64_t>();
  FieldData field;
  const auto settings = sections.next<format::Settings>();
  if (settings.size() != 1) return refusal(sizeof(format::Head), "section counts do not fit the file");
  apply(settings[0], field);
  const auto unit = sections.next<char>();
  const auto report = sections.next<MeshReport>();
  if (report.size() != 1) return refusal(sizeof(format::Head), "section counts do not fit the file");
  field.report = report[0];
  field.triangles.exact = sections.next<ExactTriangle>();
  field.triangles.records = sections.next<TriangleRecord>();
  field.bvh.nodes = sections.next<BvhNode>();
  field.pseudonormals.edges = sections.next<Vec3>();
  field.pseudonormals.vertices = sections.next<Vec3>();
  field.tree.top = sections.next<TreeNode>();
  if (!split(sections, field.tree.blocks)) return refusal(sizeof(format::Head), "block sizes do not add up");
  field.tree.levels = sections.next<LevelStats>();
  if (Result<void> good = check_field(field); !good) return good.error();
  derive_sides(field);
  derive_scan_groups(field);
  index_leaves(field);
  return StoredField{Field(std::make_shared<const FieldData>(std::move(field))),
                     std::string(unit.begin(), unit.end())};
}

}  // namespace cdfr
