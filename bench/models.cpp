#include "models.h"

#include <cstdio>
#include <filesystem>

#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"

namespace cdfr::bench {

std::vector<Model> models() {
  std::vector<Model> found{{"cube", ""}, {"six-star", ""}, {"cylinder-head", ""}};
  const std::filesystem::path data = CDFR_SHARED_DATA;
  for (const char* file : {"public/tess/NIST_MBE_PMI_1_d0.5.stl", "public/odedstein_meshes/spot.obj",
                           "public/sdfx/var/head_res222.stl"}) {
    const std::filesystem::path path = data / file;
    if (std::filesystem::exists(path)) {
      found.push_back({path.stem().string(), path.string()});
    } else {
      std::fprintf(stderr, "bench: left out, not here: %s\n", path.c_str());
    }
  }
  return found;
}

Result<Mesh> load_model(const Model& model) {
  return model.path.empty() ? make_part(model.name) : read_mesh(model.path);
}

}  // namespace cdfr::bench
