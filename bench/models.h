/// The meshes that the benches measure: made parts, and models of ../shared/data where that folder is
/// present.
#pragma once

#include <string>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::bench {

struct Model {
  std::string name;  ///< of the made part, or the file's stem
  std::string path;  ///< empty for a made part
};

/// A few of every kind that can be had here; says on stderr which are not.
std::vector<Model> models();
/// All of the public tessellations, cylinder heads and organic shapes whose folder and name hold `filter`.
std::vector<Model> public_models(const std::string& filter);
/// Unpacks what ends in .gz to a temporary file, which is gone afterwards.
Result<Mesh> load_model(const Model& model);
/// Precondition: the mesh has vertices.
Box box_of(const Mesh& mesh);

}  // namespace cdfr::bench
