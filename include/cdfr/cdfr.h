/// Everything of cdfr in one include.
#pragma once

#include "cdfr/analysis/ball.h"              // IWYU pragma: export
#include "cdfr/analysis/hot_spots.h"         // IWYU pragma: export
#include "cdfr/analysis/modulus.h"           // IWYU pragma: export
#include "cdfr/analysis/section_changes.h"   // IWYU pragma: export
#include "cdfr/analysis/sections.h"          // IWYU pragma: export
#include "cdfr/analysis/thickness.h"         // IWYU pragma: export
#include "cdfr/contour/contour.h"            // IWYU pragma: export
#include "cdfr/contour/mesh.h"               // IWYU pragma: export
#include "cdfr/core/points.h"                // IWYU pragma: export
#include "cdfr/core/result.h"                // IWYU pragma: export
#include "cdfr/core/run.h"                   // IWYU pragma: export
#include "cdfr/core/sinks.h"                 // IWYU pragma: export
#include "cdfr/core/types.h"                 // IWYU pragma: export
#include "cdfr/export/painted.h"             // IWYU pragma: export
#include "cdfr/export/write.h"               // IWYU pragma: export
#include "cdfr/field/field.h"                // IWYU pragma: export
#include "cdfr/field/plan.h"                 // IWYU pragma: export
#include "cdfr/mesh/audit.h"                 // IWYU pragma: export
#include "cdfr/mesh/flip.h"                  // IWYU pragma: export
#include "cdfr/mesh/mesh.h"                  // IWYU pragma: export
#include "cdfr/mesh/read.h"                  // IWYU pragma: export
#include "cdfr/mesh/sign.h"                  // IWYU pragma: export
#include "cdfr/mesh/weld.h"                  // IWYU pragma: export
#include "cdfr/octree/leaf.h"                // IWYU pragma: export
#include "cdfr/octree/options.h"             // IWYU pragma: export
#include "cdfr/parts/part.h"                 // IWYU pragma: export
#include "cdfr/reference/uniform.h"          // IWYU pragma: export
#include "cdfr/reference/uniform_contour.h"  // IWYU pragma: export
#include "cdfr/render/splat.h"               // IWYU pragma: export
#include "cdfr/store/build_file.h"           // IWYU pragma: export
#include "cdfr/store/store.h"                // IWYU pragma: export
#include "cdfr/version.h"                    // IWYU pragma: export
