#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <string>

#include "byte_sink.h"
#include "cdfr/export/write.h"
#include "cdfr/parts/part.h"
#include "interrupt.h"
#include "json_report.h"
#include "number_option.h"
#include "number_text.h"
#include "output_target.h"
#include "settings.h"
#include "stop.h"
#include "terminal_text.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

struct Arguments {
  std::string name, output;
  std::uint64_t copies = 1;
  Settings settings;
};

std::string known_names() {
  std::string names;
  for (const std::string_view name : part_names()) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

void write_part(const Arguments& arguments) {
  check_target(arguments.output, {".stl", ".ply", ".obj"});
  const Mesh mesh = need(make_part(arguments.name, arguments.copies), arguments.output);
  const std::size_t triangles = mesh.triangles.size(), vertices = mesh.vertices.size();
  {
    const DeferInterrupts defer;
    need(write_mesh(mesh.view(), arguments.output), arguments.output);
    stop_if_interrupted();
  }
  if (arguments.settings.json) {
    Json report = begin_report("", arguments.settings.unit);
    report["part"] = arguments.name;
    report["copies"] = arguments.copies;
    report["triangles"] = triangles;
    report["vertices"] = vertices;
    report["output"] = arguments.output;
    print_json(report);
  } else if (!arguments.settings.quiet) {
    print_text(arguments.name + ": " + count_text(triangles) + " triangles, " + count_text(vertices) +
               " vertices, written to " + terminal_text(arguments.output) + "\n");
  }
}

}  // namespace

void add_make_part(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = program.add_subcommand("make-part", "Write a part of known dimensions");
  verb->add_option("NAME", arguments->name, "One of " + known_names())->required();
  verb->add_option("-o,--output", arguments->output, "Mesh to write (.stl, .ply, .obj)")
      ->required()
      ->type_name("FILE");
  add_count(*verb, "--copies", arguments->copies, 1, no_index - 1,
            "So many side by side along x, as one mesh");
  add_report_options(*verb, arguments->settings);
  add_unit_option(*verb, arguments->settings);
  verb->footer("Example:\n  cdfr make-part cylinder-head -o head.stl");
  verb->callback([arguments] { write_part(*arguments); });
}

}  // namespace cdfr::command
