#include "cdfr/mesh/audit.h"

#include <memory>
#include <string>
#include <vector>

#include "audit_report.h"
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

Json audit_json(const Arguments& arguments, const Mesh& mesh, const MeshReport& report) {
  Json json = begin_report(arguments.input, arguments.settings.unit);
  json.update(json_of(report));
  json["box"] = json_of(report.box);
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
