#include "cdfr/mesh/audit.h"

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "audit_report.h"
#include "byte_sink.h"
#include "cdfr/export/write.h"
#include "cdfr/mesh/read.h"
#include "cdfr/mesh/weld.h"
#include "input.h"
#include "interrupt.h"
#include "json_report.h"
#include "number_option.h"
#include "number_text.h"
#include "output_target.h"
#include "provenance.h"
#include "settings.h"
#include "steering.h"
#include "stop.h"
#include "terminal_text.h"
#include "text_report.h"
#include "unit.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

constexpr std::size_t most_names_shown = 12;

struct Arguments {
  const CLI::App* verb = nullptr;
  std::string input, output;
  double weld = 0;
  const CLI::Option* welds = nullptr;  ///< --weld
  Settings settings;
};

Json audit_json(const Arguments& arguments, const Mesh& mesh, const MeshReport& report) {
  Json json = begin_report(arguments.input, arguments.settings.unit);
  json.update(json_of(report));
  json["box"] = json_of(report.box);
  json["patches"] = mesh.patch_names;
  json["warnings"] = warnings_for(report);
  json["provenance"] = json_of(
      provenance_of(arguments.input, *arguments.verb, arguments.settings.unit, report.sign(), report));
  return json;
}

std::string patches_text(const std::vector<std::string>& names) {
  std::string text = count_text(names.size()) + ":";
  for (std::size_t i = 0; i < std::min(names.size(), most_names_shown); ++i) {
    text += (i == 0 ? " " : ", ") + (names[i].empty() ? "(no name)" : terminal_text(names[i]));
  }
  return text + (names.size() > most_names_shown ? ", ..." : "");
}

void add_measures(const MeshReport& report, const std::string& unit, TextReport& text) {
  const std::string label = after_number(unit);
  text.line("closed", report.closed() ? "yes" : "no");
  text.line("embedded", report.embedded() ? "yes" : "no");
  text.line("volume", short_text(report.volume) + (label.empty() ? "" : label + "^3") +
                          (report.closed() ? "" : " (of an open surface: says little)"));
  text.line("area", short_text(report.area) + (label.empty() ? "" : label + "^2"));
  text.line("box", short_text(report.box.lo) + " to " + short_text(report.box.hi) + label);
  text.line("sign that fits", sign_text(report.sign()) + (": " + sign_reason(report)));
  for (const std::string& warning : warnings_for(report)) text.line("warning", warning);
}

std::string audit_text(const Arguments& arguments, const Mesh& mesh, const MeshReport& report) {
  TextReport text(terminal_text(arguments.input));
  add_counts(report, text);
  if (!mesh.patch_names.empty()) text.line("patches", patches_text(mesh.patch_names));
  add_measures(report, arguments.settings.unit, text);
  return text.text();
}

Json weld_json(const Arguments& arguments, const Welded& welded, const MeshReport& after) {
  return {{"tolerance", arguments.weld},
          {"merged_vertices", welded.report.merged_vertices},
          {"collapsed_triangles", welded.report.collapsed_triangles},
          {"largest_move", welded.report.largest_move},
          {"output", arguments.output},
          {"audit", json_of(after)}};
}

std::string weld_text(const Arguments& arguments, const Welded& welded, const MeshReport& after) {
  TextReport text("welded within " + short_text(arguments.weld) + after_number(arguments.settings.unit) +
                  ", written to " + terminal_text(arguments.output));
  text.line("vertices merged", count_text(welded.report.merged_vertices));
  text.line("triangles collapsed", count_text(welded.report.collapsed_triangles) + ", left out");
  text.line("largest move", short_text(welded.report.largest_move) + after_number(arguments.settings.unit));
  add_counts(after, text);
  text.line("sign that fits", sign_text(after.sign()) + (": " + sign_reason(after)));
  return text.text();
}

/// The mesh on disk stays as it is; what was welded is told and written elsewhere.
Welded write_welded(const Arguments& arguments, const Mesh& mesh) {
  Steering steering(arguments.settings, "welding");
  Welded welded = need(weld(mesh, arguments.weld, steering.run()), arguments.input);
  const DeferInterrupts defer;
  need(write_mesh(welded.mesh.view(), arguments.output), arguments.output);
  stop_if_interrupted();
  return welded;
}

MeshReport audited(const Arguments& arguments, const Mesh& mesh) {
  Steering steering(arguments.settings, "auditing");
  return need(audit(mesh.view(), steering.run()), arguments.input);
}

void audit_file(const Arguments& arguments) {
  const bool welds = arguments.welds->count() > 0;
  if (welds == arguments.output.empty()) stop_usage("--weld TOL and -o FILE go together");
  if (welds) check_target(arguments.output, {".stl", ".ply", ".obj"});
  if (is_saved_field(arguments.input)) {
    stop_failed(arguments.input, "is a saved field; audit takes a mesh");
  }
  const Mesh mesh = need(read_mesh(arguments.input), arguments.input);
  const MeshReport report = audited(arguments, mesh);
  Json json = audit_json(arguments, mesh, report);
  std::string text = audit_text(arguments, mesh, report);
  if (welds) {
    const Welded welded = write_welded(arguments, mesh);
    const MeshReport after = audited(arguments, welded.mesh);
    json["weld"] = weld_json(arguments, welded, after);
    text += weld_text(arguments, welded, after);
  }
  if (arguments.settings.json) {
    print_json(json);
  } else if (!(welds && arguments.settings.quiet)) {
    print_text(text);
  }
}

}  // namespace

void add_audit(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = program.add_subcommand("audit", "Say what a mesh is before anyone measures to it");
  arguments->verb = verb;
  verb->add_option("MESH", arguments->input, "STL, OBJ, PLY, glTF or GLB")->required();
  arguments->welds =
      add_number(*verb, "--weld", arguments->weld, {0, std::numeric_limits<double>::max()},
                 "Bring together vertices within this distance, tell what changed, and write the mesh to -o");
  verb->add_option("-o,--output", arguments->output, "Welded mesh to write (.stl, .ply, .obj)")
      ->type_name("FILE");
  add_report_options(*verb, arguments->settings);
  add_threads_option(*verb, arguments->settings);
  add_unit_option(*verb, arguments->settings);
  verb->footer("Examples:\n  cdfr audit part.stl\n  cdfr audit cracked.stl --weld 0.01 -o welded.stl");
  verb->callback([arguments] { audit_file(*arguments); });
}

}  // namespace cdfr::command
