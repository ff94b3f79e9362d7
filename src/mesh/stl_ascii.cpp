// ASCII STL: solid NAME { facet normal n n n outer loop { vertex x y z } x 3 endloop endfacet } endsolid
// NAME, ...
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

#include "mesh/coordinate.h"
#include "mesh/readers.h"
#include "mesh/text.h"

namespace cdfr {
namespace {

class AsciiStl {
 public:
  explicit AsciiStl(std::span<const std::byte> bytes) noexcept : text_(bytes) {}

  Result<Mesh> read() {
    for (auto word = text_.word_on_any_line(); !word.empty(); word = text_.word_on_any_line()) {
      if (!equal_ignoring_case(word, "solid")) return expected("solid", word);
      if (auto done = read_solid(); !done) return done.error();
    }
    return std::move(mesh_);
  }

 private:
  Result<void> read_solid() {
    mesh_.patch_names.emplace_back(text_.rest_of_line());
    while (true) {
      const auto word = text_.word_on_any_line();
      if (equal_ignoring_case(word, "endsolid")) {
        text_.rest_of_line();  // the name again, which need not agree
        return {};
      }
      if (!equal_ignoring_case(word, "facet")) return expected("facet or endsolid", word);
      if (auto done = read_facet(); !done) return done;
    }
  }

  Result<void> read_facet() {
    if (auto done = keywords({"normal"}); !done) return done;
    // The normal is not used, and exporters write nan where a facet has none; it only has to be there.
    for (int i = 0; i < 3; ++i) {
      if (text_.word_on_any_line().empty()) return expected("a facet normal", {});
    }
    if (auto done = keywords({"outer", "loop"}); !done) return done;
    if (mesh_.triangles.size() >= (no_index - 1) / 3) {
      return error_at_line(Code::out_of_range, text_.line(), "more than 2^32 - 2 vertices");
    }
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (int i = 0; i < 3; ++i) {
      if (auto done = read_vertex(); !done) return done;
    }
    mesh_.triangles.push_back({first, first + 1, first + 2});
    mesh_.patches.push_back(static_cast<std::uint32_t>(mesh_.patch_names.size() - 1));
    return keywords({"endloop", "endfacet"});
  }

  Result<void> read_vertex() {
    if (auto done = keywords({"vertex"}); !done) return done;
    Vec3 position;
    for (double* x : {&position.x, &position.y, &position.z}) {
      const auto word = text_.word_on_any_line();
      if (word.empty()) return expected("a coordinate", word);
      if (const auto fault = parse_coordinate(word, *x)) {
        return error_at_line(*fault, text_.line(),
                             "triangle " + std::to_string(mesh_.triangles.size()) + " " +
                                 coordinate_fault_text(*fault) + ": " + in_quotes(word));
      }
    }
    mesh_.vertices.push_back(position);
    return {};
  }

  Result<void> keywords(std::initializer_list<std::string_view> wanted) {
    for (const auto& keyword : wanted) {
      const auto word = text_.word_on_any_line();
      if (!equal_ignoring_case(word, keyword)) return expected(keyword, word);
    }
    return {};
  }

  Error expected(std::string_view what, std::string_view found) const {
    if (found.empty()) {
      return error_at_line(Code::file_truncated, text_.line(),
                           "ASCII STL ends where " + std::string(what) + " should be");
    }
    return error_at_line(Code::file_format, text_.line(),
                         "expected " + std::string(what) + ", found " + in_quotes(found));
  }

  TextReader text_;
  Mesh mesh_;
};

}  // namespace

Result<Mesh> read_stl_ascii(std::span<const std::byte> bytes) { return AsciiStl(bytes).read(); }

}  // namespace cdfr
