/// Sections of a mesh, and what holds for all of them.
#pragma once

#include <vector>

#include "cdfr/analysis/sections.h"
#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

Field field_of(const Mesh& mesh, const BuildOptions& options = {});

/// Fails if a section's ball, box, triangles or rank cannot be.
Sections checked_sections(const Field& field, double depth, const SectionsOptions& options = {});

}  // namespace cdfr::test
