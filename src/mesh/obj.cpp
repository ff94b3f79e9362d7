// OBJ: vertices, faces and their groups. Our own reader, because the numbering must be the file's, a comma
// for a point or an index out of range must be an error with its line, and nothing beside the file may be
// opened.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/coordinate.h"
#include "mesh/readers.h"
#include "mesh/text.h"

namespace cdfr {
namespace {

/// Statements that carry no triangle. Whatever is not in a list is refused: it may be geometry that would be
/// lost.
constexpr std::array ignored_statements = {"vt",       "vn",       "vp",         "p",        "l",   "s",
                                           "mg",       "mtllib",   "usemap",     "maplib",   "lod", "bevel",
                                           "c_interp", "d_interp", "shadow_obj", "trace_obj"};

/// Where a `g`, `o` or `usemtl` statement stands among the triangles.
struct GroupStart {
  std::uint64_t triangle = 0;
  std::string name;
};

class Obj {
 public:
  explicit Obj(std::span<const std::byte> bytes) noexcept : text_(bytes) {}

  Result<Mesh> read() {
    do {
      const auto statement = text_.word();
      if (statement.empty() || statement[0] == '#') continue;
      if (auto done = read_statement(statement); !done) return done.error();
    } while (text_.next_line());
    if (auto done = check_forward_references(); !done) return done.error();
    assign_patches();
    return std::move(mesh_);
  }

 private:
  Result<void> read_statement(std::string_view statement) {
    if (statement == "v") return read_vertex();
    if (statement == "f" || statement == "fo") return read_face();
    if (statement == "g") return start_group(groups_);
    if (statement == "o") return start_group(objects_);
    if (statement == "usemtl") return start_group(materials_);
    if (std::find(ignored_statements.begin(), ignored_statements.end(), statement) !=
        ignored_statements.end()) {
      while (!next_word().empty()) {
      }
      return {};
    }
    return fault(Code::file_format, "statement " + in_quotes(statement) + " is not supported");
  }

  Result<void> read_vertex() {
    if (mesh_.vertices.size() >= no_index - 1)
      return fault(Code::out_of_range, "more than 2^32 - 2 vertices");
    Vec3 position;
    for (double* x : {&position.x, &position.y, &position.z}) {
      const auto word = next_word();
      if (word.empty()) return fault(Code::file_format, "vertex has fewer than three coordinates");
      if (const auto wrong = parse_coordinate(word, *x)) {
        return fault(*wrong, "vertex " + std::to_string(mesh_.vertices.size()) + " " +
                                 coordinate_fault_text(*wrong) + ": " + in_quotes(word));
      }
    }
    mesh_.vertices.push_back(position);  // a weight or colour may follow; neither moves the vertex
    return {};
  }

  Result<void> read_face() {
    std::uint32_t first = 0, previous = 0;
    std::size_t corners = 0;
    for (auto word = next_word(); !word.empty() && word[0] != '#'; word = next_word(), ++corners) {
      const auto corner = read_corner(word);
      if (!corner) return corner.error();
      if (corners == 0) first = *corner;
      if (corners >= 2) {
        if (mesh_.triangles.size() >= no_index - 1) {
          return fault(Code::out_of_range, "more than 2^32 - 2 triangles");
        }
        mesh_.triangles.push_back({first, previous, *corner});
      }
      previous = *corner;
    }
    // One or two corners are a fan of no triangles; none at all is a damaged line.
    if (corners == 0) return fault(Code::file_format, "face has no corners");
    return {};
  }

  /// v, v/vt, v//vn or v/vt/vn: only v is used, the others must still be integers (or be left out).
  Result<std::uint32_t> read_corner(std::string_view word) {
    const std::string_view whole = word;
    const auto slash = std::min(word.find('/'), word.size());
    const auto index = parse_integer(word.substr(0, slash));
    bool valid = index.has_value();
    for (int parts = 1; valid && (word = word.substr(std::min(word.find('/'), word.size()))) != ""; ++parts) {
      word.remove_prefix(1);
      const auto part = word.substr(0, word.find('/'));
      valid = parts <= 2 && (part.empty() || parse_integer(part));
    }
    if (!valid) return fault(Code::file_format, "face corner " + in_quotes(whole) + " is no index");
    return resolve(*index);
  }

  Result<std::uint32_t> resolve(std::int64_t index) {
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    if (index == 0 || index < -count || index >= std::int64_t{no_index}) {
      return fault(Code::bad_index, "face index " + std::to_string(index) + " is out of range, " +
                                        std::to_string(count) + " vertices so far");
    }
    if (index < 0) return static_cast<std::uint32_t>(count + index);
    if (index > count) forward_references_.push_back({static_cast<std::uint64_t>(index), text_.line()});
    return static_cast<std::uint32_t>(index - 1);
  }

  Result<void> check_forward_references() const {
    for (const auto& [index, line] : forward_references_) {
      if (index > mesh_.vertices.size()) {
        return error_at_line(Code::bad_index, line,
                             "face index " + std::to_string(index) + " is out of range, the file has " +
                                 std::to_string(mesh_.vertices.size()) + " vertices");
      }
    }
    return {};
  }

  Result<void> start_group(std::vector<GroupStart>& starts) {
    starts.push_back({mesh_.triangles.size(), std::string(text_.rest_of_line())});
    return {};
  }

  /// Patches are numbered by the first triangle of their name; triangles before the first statement have the
  /// name "".
  void assign_patches() {
    auto& starts = !groups_.empty() ? groups_ : !objects_.empty() ? objects_ : materials_;
    if (starts.empty() || mesh_.triangles.empty()) return;
    if (starts.front().triangle > 0) starts.insert(starts.begin(), GroupStart{});
    mesh_.patches.resize(mesh_.triangles.size());
    std::map<std::string, std::uint32_t> ids;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const std::uint64_t end = i + 1 < starts.size() ? starts[i + 1].triangle : mesh_.triangles.size();
      if (starts[i].triangle == end) continue;
      const auto next_id = static_cast<std::uint32_t>(ids.size());
      const auto [entry, is_new] = ids.try_emplace(starts[i].name, next_id);
      if (is_new) mesh_.patch_names.push_back(starts[i].name);
      const auto patches = mesh_.patches.begin();
      std::fill(patches + static_cast<std::ptrdiff_t>(starts[i].triangle),
                patches + static_cast<std::ptrdiff_t>(end), entry->second);
    }
  }

  /// The next word of the statement, which goes on below a line that ends with a backslash.
  std::string_view next_word() noexcept {
    auto word = text_.word();
    while (word == "\\" && text_.at_line_end() && text_.next_line()) word = text_.word();
    return word;
  }

  Error fault(Code code, std::string_view text) const { return error_at_line(code, text_.line(), text); }

  struct ForwardReference {
    std::uint64_t index = 0;
    std::uint64_t line = 0;
  };

  TextReader text_;
  Mesh mesh_;
  std::vector<GroupStart> groups_, objects_, materials_;
  std::vector<ForwardReference> forward_references_;
};

}  // namespace

Result<Mesh> read_obj(std::span<const std::byte> bytes) { return Obj(bytes).read(); }

}  // namespace cdfr
