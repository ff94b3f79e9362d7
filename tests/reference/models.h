/// The meshes that octree and uniform field are compared on.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

struct ReferenceModel {
  std::string name;     ///< letters, digits and _ only
  std::string part;     ///< of make_part; empty for a file
  std::string file;     ///< below the shared data's public folder
  int resolution = 16;  ///< of the uniform field
  bool closed = true;
};
std::ostream& operator<<(std::ostream& out, const ReferenceModel& model);

/// Every made part, then some real models. The closed ones are embedded: the paper presupposes it, and signs
/// are compared.
std::vector<ReferenceModel> reference_models();

/// Why the model is left out of this run, or nothing. CDFR_POINTS, the number of points a model, brings in
/// the large ones.
std::string reason_to_skip(const ReferenceModel& model);

/// Points to try on a model.
int points_of(const ReferenceModel& model);

/// Precondition: nothing is the reason to skip it.
Mesh mesh_of(const ReferenceModel& model);

}  // namespace cdfr::test
