/// Modulus of heavy sections: volume over cooling surface.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/analysis/sections.h"
#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/field/field.h"

namespace cdfr {

struct ModulusOptions {
  /// e, in the mesh's unit: cubes that are not decided are halved until half their diagonal is no longer; 0
  /// takes twice the sections' error.
  double error = 0;
  /// Patches through which no heat leaves: feeders, insulated walls, planes of symmetry. Those that the mesh
  /// has none of count for nothing.
  std::vector<std::uint32_t> not_cooling{};
};

/// Of one section. Its material is every point inside the part whose closest triangle is one of
/// Section::triangles. Sections that share triangles share their material.
struct Modulus {
  double volume = 0;        ///< V, of the material
  double volume_error = 0;  ///< the true volume is within this of `volume`
  double cooling_area = 0;  ///< A, of the section's triangles that are in no patch of not_cooling
  /// V / A, a length; infinite where nothing cools. The time to solidify goes with its square (Chvorinov,
  /// "Theorie der Erstarrung von Gussstuecken", 1940).
  double value = 0;
  double error = 0;  ///< the true one is within this of `value`; infinite where nothing cools
};

/// In the order of sections.sections. A cube has a modulus of a sixth of its edge, a ball of a third of its
/// radius, a wide plate of half its thickness. Triangles belong to a section as wholes: where they are large
/// its material reaches as far as they do. Where a section has all triangles of an embedded mesh the volume
/// is the mesh's own. Precondition: the sections are the field's.
///
/// Time goes with the area of the sheets that part one section's material from the rest, and of its own
/// curved surface, over e^2. Same bits for any number of threads. Thread safe. Errors: bad_option (error
/// negative, not finite, below 2^-14 of the longest side or 2^14 ulp of the largest coordinate; a triangle
/// that the field has not), not_closed (an unsigned field has no inside), cancelled; status().
CDFR_API Result<std::vector<Modulus>> section_moduli(const Field& field, const Sections& sections,
                                                     const ModulusOptions& options = {}, const Run& run = {});

}  // namespace cdfr
