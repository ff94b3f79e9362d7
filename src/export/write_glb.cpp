#include <cmath>
#include <string>

#include "cdfr/version.h"
#include "export/frame.h"
#include "export/glb_beside.h"
#include "export/glb_part.h"
#include "export/glb_scene.h"
#include "export/painted_formats.h"
#include "export/text_line.h"

namespace cdfr {
namespace {

Json asset_of(const PaintedMesh& painted) {
  Json notes = Json::array();
  for (const std::string& note : painted.notes) notes.push_back(text_line(note));
  Json extras = {{"unit", text_line(painted.unit)}, {"notes", notes}};
  if (Paint(painted).any()) {
    extras["painted"] = painted.painted;
    extras["range"] = {painted.least, painted.greatest};
  }
  return {{"version", "2.0"}, {"generator", std::string("cdfr ") + version()}, {"extras", extras}};
}

/// Of a translucent part only fronts are drawn: a ball in it is then behind half as many layers.
int add_part_material(const PaintedMesh& painted, GlbScene& scene) {
  const double grey = Paint(painted).any() ? 1.0 : 0.6;
  Json material = {{"name", "part"},
                   {"pbrMetallicRoughness",
                    {{"baseColorFactor", {grey, grey, grey, painted.translucent ? 0.2 : 1.0}},
                     {"metallicFactor", 0.0},
                     {"roughnessFactor", 0.9}}},
                   {"doubleSided", !painted.translucent}};
  if (painted.translucent) material["alphaMode"] = "BLEND";
  return scene.add_material(material);
}

}  // namespace

Result<void> check_glb_size(const PaintedMesh& painted) {
  const Frame nowhere{PaintedMesh{}};
  return check_glb_bytes(GlbPart(painted, nowhere).bytes());
}

Result<void> write_glb(const PaintedMesh& painted, double metres_per_unit, WholeFile& file) {
  const Frame frame(painted);
  const Vec3 centre = frame.centre();
  const double scale = frame.size() * metres_per_unit;
  const double x = centre.x * metres_per_unit, y = centre.y * metres_per_unit, z = centre.z * metres_per_unit;
  if (!std::isfinite(scale) || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z) || scale == 0) {
    return Error{Code::out_of_range, 0, "in metres the mesh is too large, too small or too far away"};
  }
  GlbScene scene;
  const GlbPart part(painted, frame);
  if (!frame.empty()) {
    if (!painted.mesh.triangles.empty()) part.declare(add_part_material(painted, scene), scene);
    add_balls(painted, frame, scene);
    add_legend(painted, frame, scene);
    add_labels(painted, frame, scene);
  }
  const Json root = {{"name", "cdfr"}, {"translation", {x, y, z}}, {"scale", {scale, scale, scale}}};
  if (auto written = scene.write(asset_of(painted), root, file); !written) return written;
  return part.write(file);
}

}  // namespace cdfr
