#include "reference/models.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <ostream>

#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"

namespace cdfr::test {
namespace {

/// Of more than 130,000 triangles.
bool is_large(const std::string& part) { return part == "cylinder-head" || part == "engine"; }

std::filesystem::path path_of(const ReferenceModel& model) {
  return std::filesystem::path(CDFR_SHARED_DATA) / "public" / model.file;
}

std::string identifier(std::string text) {
  for (char& c : text) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return text;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const ReferenceModel& model) { return out << model.name; }

std::vector<ReferenceModel> reference_models() {
  std::vector<ReferenceModel> models;
  for (const std::string_view part : part_names()) {
    models.push_back({identifier(std::string(part)), std::string(part), "", 16, true});
  }
  models.push_back({"nist_1", "", "tess/NIST_MBE_PMI_1_d3_a40.stl", 16, true});
  models.push_back({"xyz_cube", "", "mikedh_trimesh/20mm-xyz-cube.stl", 12, true});
  models.push_back({"plate_holes", "", "mikedh_trimesh/plate_holes.STL", 32, true});
  models.push_back({"open_pocket", "", "mikedh_trimesh/octagonal_pocket.stl", 24, false});
  return models;
}

std::string reason_to_skip(const ReferenceModel& model) {
  const char* points = std::getenv("CDFR_POINTS");
  if (is_large(model.part) && (points == nullptr || std::atoi(points) < 1000)) {
    return "more than 130000 triangles take the uniform field 20 s; set CDFR_POINTS to 1000 or more to "
           "include them";
  }
  if (model.part.empty() && !std::filesystem::exists(path_of(model))) {
    return "no " + model.file + " in " + CDFR_SHARED_DATA;
  }
  return "";
}

int points_of(const ReferenceModel& model) {
  const char* text = std::getenv("CDFR_POINTS");
  const int points = text != nullptr ? std::max(1, std::atoi(text)) : 1500;
  return is_large(model.part) ? std::max(1, points / 20) : points;
}

Mesh mesh_of(const ReferenceModel& model) {
  return model.part.empty() ? read_mesh(path_of(model)).value() : make_part(model.part).value();
}

}  // namespace cdfr::test
