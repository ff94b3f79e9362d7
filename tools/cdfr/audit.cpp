#include "cdfr/mesh/audit.h"

#include <memory>
#include <string>
#include <vector>

#include "byte_sink.h"
#include "cdfr/mesh/read.h"
#include "input.h"
#include "json_report.h"
#include "number_text.h"
#include "settings.h"
#include "stop.h"
#include "terminal_text.h"
#include "text_report.h"
#include "unit.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

constexpr std::size_t most_names_shown = 12;

struct Arguments {
  std::string input;
  Settings settings;
};

std::vector<std::string> warnings_for(const MeshReport& report) {
  std::vector<std::string> warnings;
  if (report.closed() && report.volume < 0) {
    warnings.emplace_back(
        "the volume is negative: normals point inward, and inside and outside are exchanged");
  }
  if (report.closed() && report.nonmanifold_vertices > 0) {
    warnings.emplace_back("shells touch at single vertices");
  }
  return warnings;
}

const char* sign_that_fits(const MeshReport& report) {
  return report.closed() ? "pseudonormal" : "none: not closed, distances are unsigned";
}

void add_counts(const MeshReport& report, Json& json) {
  json["triangles"] = report.triangles;
  json["vertices"] = report.vertices;
  json["open_edges"] = report.open_edges;
  json["nonmanifold_edges"] = report.nonmanifold_edges;
  json["flipped_edges"] = report.flipped_edges;
  json["nonmanifold_vertices"] = report.nonmanifold_vertices;
  json["degenerate_triangles"] = report.degenerate_triangles;
  json["duplicate_triangles"] = report.duplicate_triangles;
  json["components"] = report.components;
}

Json audit_json(const Arguments& arguments, const Mesh& mesh, const MeshReport& report) {
  Json json = begin_report(arguments.input, arguments.settings.unit);
  add_counts(report, json);
  json["closed"] = report.closed();
  json["volume"] = report.volume;
  json["area"] = report.area;
  json["box"] = json_of(report.box);
  json["sign"] = report.closed() ? "pseudonormal" : "none";
  json["sign_text"] = sign_that_fits(report);
  json["patches"] = mesh.patch_names;
  json["warnings"] = warnings_for(report);
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
  text.line("volume", short_text(report.volume) + (label.empty() ? "" : label + "^3") +
                          (report.closed() ? "" : " (of an open surface: says little)"));
  text.line("area", short_text(report.area) + (label.empty() ? "" : label + "^2"));
  text.line("box", short_text(report.box.lo) + " to " + short_text(report.box.hi) + label);
  text.line("sign that fits", sign_that_fits(report));
  for (const std::string& warning : warnings_for(report)) text.line("warning", warning);
}

std::string audit_text(const Arguments& arguments, const Mesh& mesh, const MeshReport& report) {
  TextReport text(terminal_text(arguments.input));
  text.line("triangles", count_text(report.triangles));
  text.line("vertices", count_text(report.vertices));
  text.line("open edges", count_text(report.open_edges));
  text.line("non-manifold edges", count_text(report.nonmanifold_edges));
  text.line("flipped edges", count_text(report.flipped_edges));
  text.line("non-manifold vertices", count_text(report.nonmanifold_vertices));
  text.line("degenerate triangles", count_text(report.degenerate_triangles));
  text.line("duplicate triangles", count_text(report.duplicate_triangles));
  text.line("components", count_text(report.components));
  if (!mesh.patch_names.empty()) text.line("patches", patches_text(mesh.patch_names));
  add_measures(report, arguments.settings.unit, text);
  return text.text();
}

void audit_file(const Arguments& arguments) {
  if (is_saved_field(arguments.input)) {
    stop_failed(arguments.input, "is a saved field; audit takes a mesh");
  }
  const Mesh mesh = need(read_mesh(arguments.input), arguments.input);
  const MeshReport report = need(audit(mesh.view()), arguments.input);
  if (arguments.settings.json) {
    print_json(audit_json(arguments, mesh, report));
  } else {
    print_text(audit_text(arguments, mesh, report));
  }
}

}  // namespace

void add_audit(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = program.add_subcommand("audit", "Say what a mesh is before anyone measures to it");
  verb->add_option("MESH", arguments->input, "STL, OBJ, PLY, glTF or GLB")->required();
  add_report_options(*verb, arguments->settings);
  add_unit_option(*verb, arguments->settings);
  verb->footer("Example:\n  cdfr audit part.stl");
  verb->callback([arguments] { audit_file(*arguments); });
}

}  // namespace cdfr::command
