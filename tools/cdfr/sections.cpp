#include "cdfr/analysis/sections.h"

#include <chrono>
#include <limits>
#include <memory>
#include <string>

#include "byte_sink.h"
#include "cdfr/mesh/read.h"
#include "input.h"
#include "number_option.h"
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
  double thicker_than = 0;
  const CLI::Option *depth = nullptr, *thickness = nullptr;
  const CLI::App* verb = nullptr;
};

void check_arguments(const Arguments& arguments) {
  if (arguments.depth->count() + arguments.thickness->count() != 1)
    stop_usage("sections needs --depth or --thicker-than, one of them");
  check_sections_target(arguments.request);
}

/// The mesh to draw: INPUT itself, or --part for a saved field.
Mesh drawn_mesh(const SectionsRequest& request, const Input& input) {
  if (!is_drawn(request)) return {};
  if (!request.part.empty()) {
    Mesh part = need(read_mesh(request.part), request.part);
    if (part.triangles.size() != input.field.report().triangles)
      stop_failed(request.part, "not the field's mesh: it has another number of triangles");
    return part;
  }
  if (!input.mesh) stop_usage("a saved field is drawn on --part MESH: it keeps no vertices by file order");
  return *input.mesh;
}

SectionsFinding find(const Arguments& arguments, const Input& input, const Input* former) {
  const auto start = std::chrono::steady_clock::now();
  const SectionsRequest& request = arguments.request;
  const Mesh part = drawn_mesh(request, input);
  Steering steering(request.settings, "looking for sections");
  steering.share(0, former != nullptr ? 0.5 : 1);
  SectionsFinding finding;
  finding.sections =
      need(heavy_sections(input.field, request.depth, request.options, steering.run()), request.input);
  if (former != nullptr) {
    steering.share(0.5, 1);
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
             "How far the sections' borders may be off (longest side / 1000)");
  add_number(verb, "--min-volume", request.options.min_volume, {0, most},
             "Leaves out sections of less volume");
  add_number(verb, "--min-depth", request.options.min_depth, {0, most},
             "Leaves out sections whose largest ball has a lesser radius");
  add_number(verb, "--density", request.density, {least, most},
             "Mass of a unit of volume, for the part's mass");
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
  CLI::App* verb =
      program.add_subcommand("sections", "Heavy sections: what is thicker than a given thickness");
  arguments->verb = verb;
  verb->add_option("INPUT", arguments->request.input, "Saved field, or a mesh that is built first")
      ->required();
  add_section_options(*verb, *arguments);
  add_field_options(*verb, arguments->request.settings);
  verb->footer(
      "Example:\n  cdfr sections part.stl --thicker-than 17 --unit mm -o sections.glb\n"
      "  cdfr sections part.stl --depth 8.5 --against former.stl --json");
  verb->callback([arguments] { sections_of_input(*arguments); });
}

}  // namespace cdfr::command
