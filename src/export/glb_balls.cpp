#include <string>

#include "export/glb_beside.h"
#include "export/icosphere.h"

namespace cdfr {

using namespace glb;

/// Sea green, for no colour of the ramp comes near it.
void add_balls(const PaintedMesh& painted, const Frame& frame, GlbScene& scene) {
  if (painted.balls.empty()) return;
  const Icosphere sphere = icosphere();
  const int positions = scene.add_positions(sphere.vertices);
  const int material = scene.add_material(
      {{"name", "ball"},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {0.0, 0.55, 0.45, 0.6}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}},
       {"alphaMode", "BLEND"}});
  const int mesh =
      scene.add_mesh(Json::array({{{"attributes", {{"POSITION", positions}, {"NORMAL", positions}}},
                                   {"indices", scene.add_indices(sphere.corners)},
                                   {"material", material},
                                   {"mode", triangles_mode}}}));
  for (std::size_t i = 0; i < painted.balls.size(); ++i) {
    const auto& [centre, radius] = painted.balls[i];
    const Vec3 place = frame.inside(centre);
    const double size = radius / frame.size();
    scene.add_node({{"name", "ball " + std::to_string(i + 1)},
                    {"mesh", mesh},
                    {"translation", {place.x, place.y, place.z}},
                    {"scale", {size, size, size}},
                    {"extras", {{"center", {centre.x, centre.y, centre.z}}, {"radius", radius}}}});
  }
}

}  // namespace cdfr
