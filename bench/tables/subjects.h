/// The parts and resolutions of the papers' tables, and the real parts that stand beside them.
#pragma once

#include <optional>
#include <vector>

#include "cdfr/mesh/mesh.h"

namespace cdfr::bench {

/// A made part by name, or a real one by its file's stem.
struct Subject {
  const char* name = nullptr;
  bool is_real = false;
};

/// Table 1 and the parts of the papers' text, with the papers' figures; 0 where they give none.
struct PaperPart {
  const char* name = nullptr;
  int triangles = 0;
  double x = 0, y = 0, z = 0, depth = 0;
};

/// Of tables 2, 3 and 4.
struct FieldCase {
  Subject subject;
  int resolution = 0;
};

/// Of tables 5, 6 and 7. The depth is in the paper's unit; a real part's is the same share of its greatest.
struct ContourCase {
  Subject subject;
  double depth = 0, deepest = 0;  ///< the paper's
  std::vector<int> field_resolutions, contour_resolutions;
};

std::vector<PaperPart> paper_parts();
/// The four simple parts: table 2 for a resolution of 32, table 3 for 64.
std::vector<FieldCase> simple_fields(int resolution);
/// Table 4.
std::vector<FieldCase> large_fields();
/// Tables 5 and 6, which have the same rows.
std::vector<ContourCase> simple_contours();
/// Table 7.
std::vector<ContourCase> large_contours();
std::vector<Subject> real_parts();

/// Nothing, said on stderr, if the file is not here or no mesh.
std::optional<Mesh> mesh_of(const Subject& subject);

}  // namespace cdfr::bench
