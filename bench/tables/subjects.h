/// The parts and resolutions of the papers' tables, and the real parts that stand beside them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cdfr/mesh/mesh.h"

namespace cdfr::bench {

/// A made part by name, or a real one by its file's stem.
struct Subject {
  std::string name;
  bool is_real = false;
};

/// Table 1 and the parts of the papers' text, with the papers' figures; 0 where they give none.
struct PaperPart {
  std::string name;
  int triangles = 0;
  double x = 0, y = 0, z = 0, depth = 0;
};

/// Of tables 2, 3 and 4.
struct FieldCase {
  std::string table;  ///< of the paper
  Subject subject;
  int resolution = 0;
};

/// Of tables 5, 6 and 7. The depth is in the paper's unit; a real part's is the same share of its greatest.
struct ContourCase {
  std::string table;
  Subject subject;
  double depth = 0, deepest = 0;  ///< the paper's
  std::vector<int> field_resolutions, contour_resolutions;
};

std::vector<PaperPart> paper_parts();
std::vector<FieldCase> field_cases();
std::vector<ContourCase> contour_cases();
std::vector<Subject> real_parts();

/// Nothing, said on stderr, if the file is not here or no mesh.
std::optional<Mesh> mesh_of(const Subject& subject);

}  // namespace cdfr::bench
