#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "cdfr/store/store.h"
#include "core/whole_file.h"
#include "field/field_data.h"
#include "store/format.h"

namespace cdfr {
namespace {

static_assert(std::endian::native == std::endian::little, "a .cdfr file is written as it lies in memory");

/// Writes and hashes in one pass.
class Writer {
 public:
  explicit Writer(WholeFile& file) : file_(file), hash_(XXH64_createState(), &XXH64_freeState) {
    XXH64_reset(hash_.get(), 0);
  }

  void bytes(const void* data, std::size_t size) {
    if (size == 0) return;
    XXH64_update(hash_.get(), data, size);
    if (done_) done_ = file_.write({static_cast<const std::byte*>(data), size});
  }
  template <class T>
  void array(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes(values.data(), values.size_bytes());
  }
  void align() {
    constexpr std::array<char, format::alignment> zeros{};
    bytes(zeros.data(), (format::alignment - file_.size() % format::alignment) % format::alignment);
  }
  Result<void> finish() {
    const std::uint64_t hash = XXH64_digest(hash_.get());
    bytes(&hash, sizeof hash);
    return done_ ? file_.finish() : done_;
  }

 private:
  WholeFile& file_;
  std::unique_ptr<XXH64_state_t, decltype(&XXH64_freeState)> hash_;
  Result<void> done_;
};

format::Settings settings_of(const FieldData& field) {
  format::Settings s;
  const Lattice& lattice = field.tree.lattice;
  s.origin[0] = lattice.origin.x;
  s.origin[1] = lattice.origin.y;
  s.origin[2] = lattice.origin.z;
  s.edge = lattice.edge;
  std::copy(lattice.bricks.begin(), lattice.bricks.end(), s.bricks);
  s.max_triangles_per_leaf = static_cast<std::uint32_t>(field.options.max_triangles_per_leaf);
  s.margin = field.options.margin;
  s.gain = field.options.gain;
  s.max_level = static_cast<std::uint32_t>(field.options.max_level);
  s.sign = static_cast<std::uint8_t>(field.sign);
  s.sign_option = static_cast<std::uint8_t>(field.options.sign);
  s.lists = static_cast<std::uint8_t>(field.options.lists);
  return s;
}

/// LevelStats is padded; its padding is zero in the file.
std::vector<LevelStats> clean(const std::vector<LevelStats>& levels) {
  std::vector<LevelStats> copy(levels.size());
  if (!copy.empty()) std::memset(static_cast<void*>(copy.data()), 0, copy.size() * sizeof(LevelStats));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    copy[i].level = levels[i].level;
    copy[i].cells = levels[i].cells;
    copy[i].leaves = levels[i].leaves;
    copy[i].entries_in = levels[i].entries_in;
    copy[i].entries_pruned = levels[i].entries_pruned;
    copy[i].entries_kept = levels[i].entries_kept;
  }
  return copy;
}

format::Counts counts_of(const FieldData& field, const std::string& unit) {
  format::Counts c{};
  c[format::counts] = format::section_count;
  c[format::settings] = 1;
  c[format::unit] = unit.size();
  c[format::report] = 1;
  c[format::triangles] = field.triangles.exact.size();
  c[format::records] = field.triangles.records.size();
  c[format::bvh_nodes] = field.bvh.nodes.size();
  c[format::edge_normals] = field.pseudonormals.edges.size();
  c[format::vertex_normals] = field.pseudonormals.vertices.size();
  c[format::top] = field.tree.top.size();
  c[format::block_sizes] = field.tree.blocks.size();
  for (const Block& block : field.tree.blocks) {
    c[format::block_nodes] += block.nodes.size();
    c[format::block_leaves] += block.leaves.size();
    c[format::block_entries] += block.entries.size();
  }
  c[format::levels] = field.tree.levels.size();
  return c;
}

void write_blocks(Writer& writer, const std::vector<Block>& blocks) {
  for (const Block& b : blocks) {
    const format::BlockSize size{b.key, b.nodes.size(), b.leaves.size(), b.entries.size()};
    writer.bytes(&size, sizeof size);
  }
  writer.align();
  for (const Block& b : blocks) writer.array(std::span<const TreeNode>(b.nodes));
  writer.align();
  for (const Block& b : blocks) writer.array(std::span<const LeafRecord>(b.leaves));
  writer.align();
  for (const Block& b : blocks) writer.array(std::span<const Entry>(b.entries));
  writer.align();
}

}  // namespace

Result<void> save(const Field& field, const std::filesystem::path& path, const std::string& unit) {
  const FieldData& data = field.data();
  Result<WholeFile> file = WholeFile::create(path);
  if (!file) return file.error();
  Writer writer(*file);
  const format::Counts counts = counts_of(data, unit);
  const format::Head head{
      format::magic, format::version, format::section_count, format::file_size(counts), {}};
  writer.bytes(&head, sizeof head);
  const auto section = [&]<class T>(std::span<const T> values) {
    writer.array(values);
    writer.align();
  };
  const format::Settings settings = settings_of(data);
  section(std::span<const std::uint64_t>(counts));
  section(std::span<const format::Settings>(&settings, 1));
  section(std::span<const char>(unit));
  section(std::span<const MeshReport>(&data.report, 1));
  section(std::span<const ExactTriangle>(data.triangles.exact));
  section(std::span<const TriangleRecord>(data.triangles.records));
  section(std::span<const BvhNode>(data.bvh.nodes));
  section(std::span<const Vec3>(data.pseudonormals.edges));
  section(std::span<const Vec3>(data.pseudonormals.vertices));
  section(std::span<const TreeNode>(data.tree.top));
  write_blocks(writer, data.tree.blocks);
  section(std::span<const LevelStats>(clean(data.tree.levels)));
  return writer.finish();
}

}  // namespace cdfr
