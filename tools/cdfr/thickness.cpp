#include "cdfr/analysis/thickness.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>

#include "byte_sink.h"
#include "choice_option.h"
#include "input.h"
#include "number_option.h"
#include "output_target.h"
#include "steering.h"
#include "stop.h"
#include "thickness_painted.h"
#include "thickness_report.h"
#include "thickness_request.h"
#include "thickness_table.h"
#include "thickness_words.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

struct Arguments {
  ThicknessRequest request;
  const CLI::Option *spacing = nullptr, *at = nullptr, *facet = nullptr, *cone = nullptr, *rays = nullptr,
                    *reach = nullptr, *change = nullptr;
};

bool given(const CLI::Option* option) { return option->count() > 0; }

bool is_painted(const std::string& output) {
  const std::string extension = extension_of(output);
  return extension == ".glb" || extension == ".vtp";
}

void check_arguments(const Arguments& arguments) {
  const ThicknessRequest& request = arguments.request;
  const bool ray = request.options.method == ThicknessMethod::ray;
  if (given(arguments.spacing) && given(arguments.at)) stop_usage("--spacing and --at: one of them");
  if (!ray && (given(arguments.cone) || given(arguments.rays)))
    stop_usage("--cone and --rays are for --method ray");
  if (ray && given(arguments.facet)) stop_usage("--facet is for --method sphere");
  if (given(arguments.cone) != given(arguments.rays)) stop_usage("--cone and --rays go together");
  if (request.against.empty() && (given(arguments.reach) || given(arguments.change)))
    stop_usage("--reach and --change are for --against");
  if (!request.part.empty() && (request.output.empty() || !is_painted(request.output)))
    stop_usage("--part is for -o FILE.glb or FILE.vtp");
  if (!request.output.empty()) check_target(request.output, {".csv", ".npy", ".ply", ".glb", ".vtp"});
}

void write_output(const ThicknessRequest& request, const Mesh& part, const Input& input,
                  const ThicknessFinding& finding) {
  if (request.output.empty()) return;
  if (is_painted(request.output)) {
    write_thickness_painted(request, part, input.unit, finding);
    return;
  }
  const auto sink = whole_file(request.output);
  write_thickness_table(*sink, finding.walls.samples, extension_of(request.output));
  stop_if_interrupted();
  sink->finish();
}

ThicknessFinding measure(const ThicknessRequest& request, const Input& input, const Input* former) {
  const auto start = std::chrono::steady_clock::now();
  const bool paints = !request.output.empty() && is_painted(request.output);
  const Mesh part = paints ? drawn_mesh(request.part, input) : Mesh();
  Steering steering(request.settings, "measuring");
  steering.share(0, former != nullptr ? 0.5 : 1);
  ThicknessFinding finding;
  finding.walls = need(thickness(input.field, request.options, steering.run()), request.input);
  if (former != nullptr) {
    steering.share(0.5, 1);
    finding.thinning = need(thinning(input.field, finding.walls, request.options, former->field,
                                     request.thinning, steering.run()),
                            request.against);
  }
  finding.provenance = provenance_of(request.input, *request.verb, input);
  write_output(request, part, input, finding);
  stop_if_interrupted();
  finding.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return finding;
}

void thickness_of_input(Arguments& arguments) {
  check_arguments(arguments);
  ThicknessRequest& request = arguments.request;
  if (given(arguments.spacing)) request.options.at = SampleAt::spacing;
  const Input input = open_input(request.input, request.settings, Demand::inside);
  std::optional<Input> former;
  if (!request.against.empty()) former = open_input(request.against, request.settings, Demand::inside);
  const ThicknessFinding finding = measure(request, input, former ? &*former : nullptr);
  if (request.settings.json) {
    print_json(thickness_json(request, input, finding));
  } else if (!request.settings.quiet) {
    print_text(thickness_text(request, input, finding));
  }
}

void add_measure_options(CLI::App& verb, Arguments& arguments) {
  constexpr double least = std::numeric_limits<double>::min();
  constexpr double most = std::numeric_limits<double>::max();
  ThicknessOptions& options = arguments.request.options;
  add_choice(verb, "--method", options.method, methods,
             "sphere (largest ball that touches the wall) or ray (first hit along the inward normal)");
  arguments.at =
      add_choice(verb, "--at", options.at, sample_places, "Where: faces (their centres) or vertices");
  arguments.spacing = add_number(verb, "--spacing", options.spacing, {least, most},
                                 "Several places a triangle, about so far apart");
  arguments.facet = add_number(verb, "--facet", options.facet, {0, most},
                               "How far a ball may enter the mesh (estimated chord error); 0 is exact on it");
  add_number(verb, "--sharp", options.sharp, {least, 179},
             "Degrees; edges that turn more are design edges (30)");
  add_choice(verb, "--edges", options.edges, edge_policies,
             "At design edges: sphere (the ball's own value), extrapolate or skip");
  add_number(verb, "--error", options.error, {least, most}, "Largest error of the thickness, but for facets");
  arguments.cone =
      add_number(verb, "--cone", options.cone, {0, 89}, "Half the opening of a cone of rays, degrees");
  arguments.rays = add_count(verb, "--rays", options.rays, 1, 10000, "Rays in the cone; the shortest counts");
  verb.add_flag("--clearance", options.clearance, "Gaps outside instead of walls inside");
  add_number(verb, "--largest", options.largest, {least, most},
             "Thickness beyond which nothing is looked for (the box's diagonal)");
}

void add_report_on_walls(CLI::App& verb, Arguments& arguments) {
  constexpr double least = std::numeric_limits<double>::min();
  constexpr double most = std::numeric_limits<double>::max();
  ThicknessRequest& request = arguments.request;
  add_number(verb, "--thinner-than", request.options.thinner_than, {least, most},
             "What counts as thin, strictly (the thinnest twentieth of the area)");
  add_count(verb, "--bins", request.options.bins, 1, 100000, "Bins of the histogram (20)");
  add_count(verb, "--places", request.options.places, 0, 1000000, "Thin places that are listed (20)");
  add_number(verb, "--density", request.density, {least, most}, "Mass of a unit of volume, for the mass");
  verb.add_option("--against", request.against, "Former revision, mesh or field: lists walls that thinned")
      ->type_name("FILE");
  arguments.reach = add_number(verb, "--reach", request.thinning.reach, {least, most},
                               "How far the former surface may be (longest side / 100)");
  arguments.change = add_number(verb, "--change", request.thinning.change, {least, most},
                                "Loss that is listed (both errors and facet tolerances)");
  verb.add_option("-o,--output", request.output,
                  "Samples (.csv, .npy, .ply), or the part coloured by thickness (.glb, .vtp)")
      ->type_name("FILE");
  verb.add_option("--part", request.part, "Mesh to colour, if INPUT is a saved field")->type_name("MESH");
}

}  // namespace

void add_thickness(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = program.add_subcommand("thickness", "Wall thickness, or gaps, and the thinnest places");
  arguments->request.verb = verb;
  verb->add_option("INPUT", arguments->request.input, "Saved field, or a mesh that is built first")
      ->required();
  add_measure_options(*verb, *arguments);
  add_report_on_walls(*verb, *arguments);
  add_field_options(*verb, arguments->request.settings);
  verb->footer(
      "Example:\n  cdfr thickness part.stl --thinner-than 2.5 --unit mm -o walls.csv\n"
      "  cdfr thickness part.stl --edges extrapolate -o walls.glb --against former.stl");
  verb->callback([arguments] { thickness_of_input(*arguments); });
}

}  // namespace cdfr::command
