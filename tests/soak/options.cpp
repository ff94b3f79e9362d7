#include "soak/options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <thread>
#include <vector>

namespace cdfr::soak {

Parsed parse(int argc, char** argv) {
  Options options;
  std::vector<std::string> replay;
  CLI::App app(
      "Checks the sign of the distance at many points of closed, embedded meshes against an exact oracle. "
      "Status "
      "1 if any is wrong, 2 for wrong usage.",
      "signs");
  app.add_option("--points", options.points, "points in all, shared out among the meshes")
      ->capture_default_str();
  app.add_option("--meshes", options.meshes, "meshes: models and made ones in turn")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "another seed makes other meshes and points")->capture_default_str();
  app.add_option("--threads", options.threads, "0: all; the outcome never depends on it")
      ->check(CLI::Range(0, 1024));
  app.add_option("--second", options.second_opinion,
                 "one point in so many is given to CGAL's Side_of_triangle_mesh too; 0: none")
      ->capture_default_str();
  app.add_flag("--lenient", options.lenient,
               "let pass what is wrong within 4 ulp of the surface, ulp at the largest coordinate");
  app.add_option("--only", options.only, "only meshes with this in their name");
  app.add_option("--replay", replay,
                 "NAME [X Y Z]: that mesh alone, that point alone; hexadecimal floats too")
      ->expected(1, 4);
  app.add_option("--write", options.write, "with --replay: the mesh as .ply or .obj");
  try {
    app.parse(argc, argv);
    if (replay.size() == 2 || replay.size() == 3)
      throw CLI::ValidationError("--replay", "takes NAME or NAME X Y Z");
    if (!replay.empty()) options.replay = replay[0];
    if (replay.size() == 4) {
      double coordinates[3];
      for (std::size_t i = 0; i < 3; ++i) {
        char* end = nullptr;
        coordinates[i] = std::strtod(replay[i + 1].c_str(), &end);
        if (end == replay[i + 1].c_str() || *end != '\0' || !std::isfinite(coordinates[i]))
          throw CLI::ValidationError("--replay", "no number: " + replay[i + 1]);
      }
      options.point = Vec3{coordinates[0], coordinates[1], coordinates[2]};
    }
  } catch (const CLI::ParseError& error) {
    return {options, app.exit(error) == 0 ? 0 : 2};
  }
  if (options.threads == 0) options.threads = std::max(1U, std::thread::hardware_concurrency());
  return {options, std::nullopt};
}

}  // namespace cdfr::soak
