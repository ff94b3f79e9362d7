/// Families of triangles and of queries to them, from friendly to hostile.
#pragma once

#include <array>
#include <ostream>
#include <span>

#include "cdfr/core/types.h"
#include "oracle/random.h"

namespace cdfr::oracle {

using Corners = std::array<Vec3, 3>;

/// Coordinates as the library supports them: 0 or 2^-200 to 2^200 in size.
struct ShapeFamily {
  const char* name;
  Corners (*make)(Random&);
  bool no_area = false;  ///< triangles of this family may have none
};
inline std::ostream& operator<<(std::ostream& out, const ShapeFamily& family) { return out << family.name; }
std::span<const ShapeFamily> shape_families() noexcept;

/// Finite coordinates no larger than 2^240.
struct QueryFamily {
  const char* name;
  Vec3 (*make)(Random&, const Corners&);
};
std::span<const QueryFamily> query_families() noexcept;

}  // namespace cdfr::oracle
