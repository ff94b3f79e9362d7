#include "soak/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace cdfr::soak {
namespace {

double number(const std::string& text) {
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(x))
    throw CLI::ValidationError("--replay", "no number: " + text);
  return x;
}

}  // namespace

Parsed parse(int argc, char** argv) {
  Options options;
  std::vector<std::string> replay;
  CLI::App app(
      "Checks the sign of the distance at many points of closed, embedded, outward meshes against an exact "
      "oracle. Status 1 if any is wrong, 2 for wrong usage.",
      "signs");
  double points = static_cast<double>(options.points);  // so that 1e7 is a number
  app.add_option("--points", points, "points in all, shared out among the meshes")
      ->check(CLI::Range(1.0, 1e15))
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
    options.points = static_cast<std::uint64_t>(points);
    if (replay.size() == 2 || replay.size() == 3)
      throw CLI::ValidationError("--replay", "takes NAME or NAME X Y Z");
    if (!replay.empty()) options.replay = replay[0];
    if (replay.size() == 4) options.point = Vec3{number(replay[1]), number(replay[2]), number(replay[3])};
  } catch (const CLI::ParseError& error) {
    return {options, app.exit(error) == 0 ? 0 : 2};
  }
  if (options.threads == 0) options.threads = std::max(1U, std::thread::hardware_concurrency());
  return {options, std::nullopt};
}

}  // namespace cdfr::soak
