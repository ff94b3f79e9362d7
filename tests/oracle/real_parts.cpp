#include "oracle/real_parts.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace cdfr::oracle {

std::vector<Model> real_parts() {
  constexpr std::array<std::string_view, 6> files{
      "tess/NIST_MBE_PMI_5_d0.5.stl",      "tess/kcl_focusrite-scarlett-mounting-bracket.stl",
      "tess/kcl_flange-with-patterns.stl", "odri/transmission_pulley_at3_t30_output.STL",
      "odedstein_meshes/spot.obj",         "sdfx/var/head_res222.stl"};
  std::vector<Model> found = models();
  std::erase_if(found, [&](const Model& model) {
    return std::ranges::none_of(files, [&](std::string_view file) { return model.file.ends_with(file); });
  });
  return found;
}

}  // namespace cdfr::oracle
