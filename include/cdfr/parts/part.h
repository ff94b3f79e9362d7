/// The made parts: closed, outward oriented meshes of known dimensions, for tables, demos and tests.
#pragma once

#include <span>
#include <string_view>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// Names that make_part takes: cube, tetrahedron, one-tooth, six-star, cylinder-head.
CDFR_API std::span<const std::string_view> part_names() noexcept;

/// The part of that name; the same bits on every machine. Errors: bad_option for an unknown name. Thread safe.
CDFR_API Result<Mesh> make_part(std::string_view name);

}  // namespace cdfr
