#include "models.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"
#include "unpacked.h"

namespace cdfr::bench {
namespace {

namespace fs = std::filesystem;

bool ends_with_any(const std::string& name, std::initializer_list<const char*> ends) {
  return std::any_of(ends.begin(), ends.end(), [&](const char* end) { return name.ends_with(end); });
}

}  // namespace

std::vector<Model> models() {
  std::vector<Model> found{{"cube", ""}, {"six-star", ""}, {"cylinder-head", ""}};
  const fs::path data = CDFR_SHARED_DATA;
  for (const char* file : {"public/tess/NIST_MBE_PMI_1_d0.5.stl", "public/odedstein_meshes/spot.obj",
                           "public/sdfx/var/head_res222.stl"}) {
    const fs::path path = data / file;
    if (fs::exists(path)) {
      found.push_back({path.stem().string(), path.string()});
    } else {
      std::fprintf(stderr, "bench: left out, not here: %s\n", path.c_str());
    }
  }
  return found;
}

std::vector<Model> public_models(const std::string& filter) {
  const fs::path root = fs::path(CDFR_SHARED_DATA) / "public";
  std::vector<Model> found;
  for (const char* folder : {"tess", "sdfx", "odedstein_meshes"}) {
    if (!fs::exists(root / folder)) {
      std::fprintf(stderr, "bench: left out, not here: %s\n", (root / folder).c_str());
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string path = entry.path().string();
      if (!ends_with_any(path, {".stl", ".obj", ".ply.gz"})) continue;
      if (path.substr(root.string().size()).find(filter) == std::string::npos) continue;
      const fs::path name = path.ends_with(".gz") ? entry.path().stem() : entry.path();
      found.push_back({name.stem().string(), path});
    }
  }
  std::sort(found.begin(), found.end(), [](const Model& a, const Model& b) { return a.path < b.path; });
  return found;
}

Result<Mesh> load_model(const Model& model) {
  if (model.path.empty()) return make_part(model.name);
  if (model.path.ends_with(".gz")) return read_mesh(Unpacked(model.path).path());
  return read_mesh(model.path);
}

Box box_of(const Mesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Vec3& v : mesh.vertices) {
    box.lo = {std::min(box.lo.x, v.x), std::min(box.lo.y, v.y), std::min(box.lo.z, v.z)};
    box.hi = {std::max(box.hi.x, v.x), std::max(box.hi.y, v.y), std::max(box.hi.z, v.z)};
  }
  return box;
}

}  // namespace cdfr::bench
