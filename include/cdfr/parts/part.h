/// The made parts: closed, outward oriented meshes of known dimensions, for tables, demos and tests.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// Names that make_part takes: cube, tetrahedron, one-tooth, six-star, cylinder-head.
CDFR_API std::span<const std::string_view> part_names() noexcept;

/// The part of that name, or so many copies of it side by side along x as one mesh, the first where the part
/// is. Between two lies a gap of a tenth of the part's width, rounded up so that every copy has the part's
/// shape bit by bit. The same bits on every machine. Errors: bad_option for an unknown name, no copy or more
/// than 2^32 - 2 triangles in all. Thread safe.
CDFR_API Result<Mesh> make_part(std::string_view name, std::uint64_t copies = 1);

}  // namespace cdfr
