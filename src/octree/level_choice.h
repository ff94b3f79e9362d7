/// How deep leaves may lie if nobody says.
#pragma once

#include <cstdint>

namespace cdfr {

/// Level 5 where a field's cubes are a few thousand triangles large, as in parts of any usual shape; deeper
/// where they hold more, in long parts and in fine ones, so that the smallest cell is about as wide as four
/// triangles. At most 12. Too deep costs little: splits that do not pay are not made, and leaves are bounded
/// (build.h). `area` is the mesh's.
int level_for(double edge, double area, std::uint64_t triangles) noexcept;

}  // namespace cdfr
