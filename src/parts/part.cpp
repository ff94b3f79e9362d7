#include "cdfr/parts/part.h"

#include <array>
#include <cstddef>
#include <string>

#include "parts/copies.h"
#include "parts/made_parts.h"

namespace cdfr {
namespace {

constexpr std::array<std::string_view, 9> names{"cube",     "tetrahedron", "one-tooth", "two-ended-tooth",
                                                "six-star", "connector",   "brevi",     "cylinder-head",
                                                "engine"};
constexpr std::array<Mesh (*)(), names.size()> makers{
    cube, tetrahedron, one_tooth, two_ended_tooth, six_star, connector, brevi, cylinder_head, engine};

}  // namespace

std::span<const std::string_view> part_names() noexcept { return names; }

Result<Mesh> make_part(std::string_view name, std::uint64_t copies) {
  std::string known;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return copied(makers[i](), name, copies);
    known += (i == 0 ? "" : ", ") + std::string(names[i]);
  }
  return Error{Code::bad_option, 0, "no part of that name; there are " + known};
}

}  // namespace cdfr
