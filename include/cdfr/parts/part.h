/// The made parts: closed, outward oriented, embedded meshes of known dimensions, for tables, demos and
/// tests. They have the triangles, boxes and greatest depths that papers/huang-2001 and
/// papers/huang-2001-report print, but one triangle more where a closed mesh cannot have the number, and for
/// the two-ended tooth nothing is printed. The papers' own parts are not public, and these stand in for them;
/// beyond cube, tetrahedron, one-tooth and six-star they share little more than those numbers with them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// Names that make_part takes: cube, tetrahedron, one-tooth, two-ended-tooth, six-star, connector, brevi,
/// cylinder-head, engine.
CDFR_API std::span<const std::string_view> part_names() noexcept;

/// The part of that name, or so many copies of it side by side along x as one mesh, the first where the part
/// is. Between two lies a gap of a tenth of the part's width, rounded up so that every copy has the part's
/// shape bit by bit; of connector and brevi, whose widths are decimals, but for the rounding of x. The same
/// bits on every machine. Errors: bad_option for an unknown name, no copy or more than 2^32 - 2 triangles in
/// all. Thread safe.
CDFR_API Result<Mesh> make_part(std::string_view name, std::uint64_t copies = 1);

}  // namespace cdfr
