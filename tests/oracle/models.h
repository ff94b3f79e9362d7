/// The models that the tests run over: the made parts, and the files of the shared data.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::oracle {

/// A part of make_part, or a file below the shared data's public folder.
struct Model {
  std::string name;  ///< letters, digits and _ only
  std::string part;  ///< empty for a file
  std::string file;  ///< empty for a part
};
std::ostream& operator<<(std::ostream& out, const Model& model);

/// The parts in their own order, then the STL, OBJ and PLY files by path; only the parts if there is no
/// shared data.
std::vector<Model> models();
Result<Mesh> load(const Model& model);

}  // namespace cdfr::oracle
