#include "cdfr/analysis/sections.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "ball_drawing.h"
#include "byte_sink.h"
#include "hot_spots.h"
#include "input.h"
#include "number_option.h"
#include "patch_number.h"
#include "sections_finding.h"
#include "sections_output.h"
#include "sections_report.h"
#include "steering.h"
#include "stop.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

struct Arguments {
  SectionsRequest request;
  double thicker_than = 0, prominence = 0;
  std::vector<std::string> feeders;
  const CLI::Option *depth = nullptr, *thickness = nullptr;
  const CLI::App* verb = nullptr;
};

bool asks_hot_spots(const Arguments& arguments) {
  return arguments.depth->count() + arguments.thickness->count() == 0;
}

void check_arguments(const Arguments& arguments) {
  if (arguments.depth->count() + arguments.thickness->count() == 2)
    stop_usage("sections takes --depth or --thicker-than, not both");
  const bool hot = asks_hot_spots(arguments);
  for (const char* name :
       {"--min-volume", "--min-depth", "--density", "--against", "--modulus", "--not-cooling"}) {
    if (hot && arguments.verb->count(name) > 0)
      stop_usage(std::string(name) + " is for sections: it needs --depth or --thicker-than");
  }
  for (const char* name : {"--prominence", "--feed"}) {
    if (!hot && arguments.verb->count(name) > 0)
      stop_usage(std::string(name) + " is for hot spots: not with --depth or --thicker-than");
  }
  if (!arguments.request.not_cooling.empty() && !arguments.request.modulus)
    stop_usage("--not-cooling is for --modulus");
  check_sections_target(arguments.request);
}

void list_hot_spots(const Arguments& arguments) {
  const SectionsRequest& request = arguments.request;
  HotSpotsRequest hot{request.input, request.output, request.part, {}, arguments.feeders, request.settings};
  hot.options.error = request.options.error;
  hot.options.prominence = arguments.prominence;
  hot_spots_of_input(hot, *arguments.verb);
}

SectionsFinding find(const Arguments& arguments, const Input& input, const Input* former) {
  const auto start = std::chrono::steady_clock::now();
  const SectionsRequest& request = arguments.request;
  const Mesh part = is_drawn(request.output) ? drawn_mesh(request.part, input) : Mesh{};
  const ModulusOptions cooling{0, patch_numbers("--not-cooling", request.not_cooling, input)};
  Steering steering(request.settings, "looking for sections");
  const double each = 1.0 / (1 + (request.modulus ? 1 : 0) + (former != nullptr ? 1 : 0));
  steering.share(0, each);
  SectionsFinding finding;
  finding.sections =
      need(heavy_sections(input.field, request.depth, request.options, steering.run()), request.input);
  if (request.modulus) {
    steering.share(each, 2 * each);
    finding.moduli =
        need(section_moduli(input.field, finding.sections, cooling, steering.run()), request.input);
  }
  if (former != nullptr) {
    steering.share(1 - each, 1);
    finding.former =
        need(heavy_sections(former->field, request.depth, request.options, steering.run()), request.against);
    finding.changes = section_changes(finding.sections, *finding.former);
  }
  finding.provenance = provenance_of(request.input, *arguments.verb, input);
  finding.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_sections(request, input, part, finding);
  stop_if_interrupted();
  return finding;
}

void sections_of_input(Arguments& arguments) {
  check_arguments(arguments);
  if (asks_hot_spots(arguments)) return list_hot_spots(arguments);
  SectionsRequest& request = arguments.request;
  if (arguments.thickness->count() > 0) request.depth = arguments.thicker_than / 2;
  const Input input = open_input(request.input, request.settings, Demand::inside);
  std::optional<Input> former;
  if (!request.against.empty()) former = open_input(request.against, request.settings, Demand::inside);
  const SectionsFinding finding = find(arguments, input, former ? &*former : nullptr);
  if (request.settings.json) {
    print_json(sections_json(request, input, finding));
  } else if (!request.settings.quiet) {
    print_text(sections_text(request, input, finding));
  }
}

void add_section_options(CLI::App& verb, Arguments& arguments) {
  constexpr double least = std::numeric_limits<double>::min();
  constexpr double most = std::numeric_limits<double>::max();
  SectionsRequest& request = arguments.request;
  arguments.depth = add_number(verb, "--depth", request.depth, {least, most},
                               "What is deeper below the surface counts, strictly");
  arguments.thickness = add_number(verb, "--thicker-than", arguments.thicker_than, {least, most},
                                   "The same as a diameter: --depth of half of it");
  add_number(verb, "--error", request.options.error, {least, most},
             "How far borders may be off, or depths of necks (longest side / 1000, for hot spots at least a "
             "twentieth of the greatest depth)");
  add_number(verb, "--prominence", arguments.prominence, {least, most},
             "Hot spots are deeper by more than that than the necks that lead on (2 errors)");
  verb.add_option("--feed", arguments.feeders,
                  "Patches that metal is fed through, names or numbers: how wide "
                  "the way is from each hot spot")
      ->delimiter(',')
      ->type_name("PATCH,...");
  add_number(verb, "--min-volume", request.options.min_volume, {0, most},
             "Leaves out sections of less volume");
  add_number(verb, "--min-depth", request.options.min_depth, {0, most},
             "Leaves out sections whose largest ball has a lesser radius");
  add_number(verb, "--density", request.density, {least, most},
             "Mass of a unit of volume, for the part's mass");
  verb.add_flag("--modulus", request.modulus,
                "The modulus of each section: its volume over its cooling surface");
  verb.add_option("--not-cooling", request.not_cooling,
                  "Patches through which no heat leaves, names or numbers, for --modulus")
      ->delimiter(',')
      ->type_name("PATCH,...");
  verb.add_option("--against", request.against,
                  "Former revision, mesh or field: what grew, shrank, is new or gone")
      ->type_name("FILE");
  verb.add_option("-o,--output", request.output,
                  "The report (.json), a table (.csv), or the part with its sections (.glb, .ply, .vtp)")
      ->type_name("FILE");
  verb.add_option("--part", request.part, "Mesh to draw, if INPUT is a saved field")->type_name("MESH");
}

}  // namespace

void add_sections(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = program.add_subcommand(
      "sections", "Heavy sections: what is thicker than a given thickness, or without one the hot spots");
  arguments->verb = verb;
  verb->add_option("INPUT", arguments->request.input, "Saved field, or a mesh that is built first")
      ->required();
  add_section_options(*verb, *arguments);
  add_field_options(*verb, arguments->request.settings);
  verb->footer(
      "Example:\n  cdfr sections part.stl --thicker-than 17 --unit mm -o sections.glb\n"
      "  cdfr sections part.stl --depth 8.5 --against former.stl --json\n"
      "  cdfr sections part.obj --feed riser");
  verb->callback([arguments] { sections_of_input(*arguments); });
}

}  // namespace cdfr::command
