#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "byte_sink.h"
#include "cdfr/field/plan.h"
#include "cdfr/mesh/flip.h"
#include "cdfr/mesh/read.h"
#include "cdfr/store/build_file.h"
#include "field_report.h"
#include "input.h"
#include "number_option.h"
#include "number_text.h"
#include "output_target.h"
#include "steering.h"
#include "stop.h"
#include "terminal_text.h"
#include "text_report.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

struct Arguments {
  std::string input, output;
  bool compress = false, fresh = false, plan = false;
  std::uint64_t memory = 0;
  Settings settings;
};

/// A signal ends the program wherever it is: the work folder knows how to go on.
FileBuildReport built_file(const Arguments& arguments) {
  FileBuildOptions options;
  options.build = arguments.settings.build;
  options.unit = arguments.settings.unit;
  options.flip = arguments.settings.flip;
  options.packing = arguments.compress ? Packing::zstd : Packing::none;
  options.memory = arguments.memory;
  options.fresh = arguments.fresh;
  Steering steering(arguments.settings, "building", OnSignal::end);
  const Result<FileBuildReport> built =
      build_file(arguments.input, arguments.output, options, steering.run());
  if (built) return *built;
  const bool about_output = built.error().code == Code::file_write;
  stop_for(built.error(), about_output ? arguments.output : arguments.input);
}

void plan(const Arguments& arguments) {
  if (is_saved_field(arguments.input)) stop_failed(arguments.input, "is a saved field; --plan takes a mesh");
  const auto start = std::chrono::steady_clock::now();
  Mesh mesh = need(read_mesh(arguments.input), arguments.input);
  if (arguments.settings.flip) flip(mesh);
  const double reading = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Steering steering(arguments.settings, "planning");
  FieldPlan planned =
      need(plan_field(mesh.view(), arguments.settings.build, steering.run()), arguments.input);
  // Read and hashed, then the file written twice (write_field), at about a gigabyte a second.
  planned.seconds += 2 * reading + 2e-9 * static_cast<double>(planned.bytes) + 0.01;
  if (arguments.settings.json) {
    Json report = begin_report(arguments.input, arguments.settings.unit);
    report["plan"] = {{"triangles", planned.triangles},   {"leaves", planned.leaves},
                      {"entries", planned.entries},       {"bytes", planned.bytes},
                      {"peak_bytes", planned.peak_bytes}, {"seconds", planned.seconds}};
    return print_json(report);
  }
  TextReport report(terminal_text(arguments.input));
  report.line("triangles", count_text(planned.triangles));
  report.line("leaves", "about " + count_text(planned.leaves));
  report.line("memory and file", "about " + bytes_text(planned.bytes));
  report.line("while it is built", "about " + bytes_text(planned.peak_bytes) + ", or as --memory says");
  report.line("time", "about " + seconds_text(planned.seconds));
  print_text(report.text());
}

void build(const Arguments& arguments) {
  if (arguments.plan) return plan(arguments);
  if (arguments.output.empty()) stop_usage("--output is required, but for --plan");
  check_target(arguments.output, {".cdfr"});
  if (is_saved_field(arguments.input)) {
    stop_failed(arguments.input, "is a saved field; build takes a mesh");
  }
  const auto start = std::chrono::steady_clock::now();
  const FileBuildReport built = built_file(arguments);
  Settings to_read = arguments.settings;
  to_read.build_options.clear();  // they were for the build
  Input input = open_input(arguments.output, to_read);
  input.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (arguments.settings.json) {
    Json report = field_json(arguments.input, input);
    report["output"] = arguments.output;
    report["blocks"] = built.blocks;
    report["blocks_kept"] = built.blocks_kept;
    print_json(report);
  } else if (!arguments.settings.quiet) {
    print_text(field_text(arguments.input, input) + "written to " + terminal_text(arguments.output) + "\n");
  }
}

}  // namespace

void add_build(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = program.add_subcommand("build", "Build the distance field of a mesh and save it");
  verb->add_option("MESH", arguments->input, "STL, OBJ, PLY, glTF or GLB")->required();
  verb->add_option("-o,--output", arguments->output, "Field to write (.cdfr)")->type_name("FILE");
  verb->add_flag("--plan", arguments->plan, "Only say what the field would be: leaves, bytes, memory, time");
  verb->add_flag("--compress", arguments->compress,
                 "Pack the file (zstd), for archives: it is read into memory whole, not mapped");
  add_size(*verb, "--memory", arguments->memory,
           "Anonymous memory that the work may take; what does not fit lies on disk. Without it, as much as "
           "it likes");
  verb->add_flag("--fresh", arguments->fresh, "Start over, whatever an interrupted build has left");
  add_field_options(*verb, arguments->settings);
  verb->footer("Example:\n  cdfr build part.stl -o part.cdfr --unit mm");
  verb->callback([arguments] { build(*arguments); });
}

}  // namespace cdfr::command
