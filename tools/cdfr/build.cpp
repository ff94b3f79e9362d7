#include <memory>
#include <string>

#include "byte_sink.h"
#include "cdfr/store/store.h"
#include "field_report.h"
#include "input.h"
#include "interrupt.h"
#include "output_target.h"
#include "stop.h"
#include "terminal_text.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

struct Arguments {
  std::string input, output;
  bool compress = false;
  Settings settings;
};

void build(const Arguments& arguments) {
  check_target(arguments.output, {".cdfr"});
  if (is_saved_field(arguments.input)) {
    stop_failed(arguments.input, "is a saved field; build takes a mesh");
  }
  const Input input = open_input(arguments.input, arguments.settings);
  {
    const DeferInterrupts defer;
    need(save(input.field, arguments.output, input.unit, arguments.compress ? Packing::zstd : Packing::none),
         arguments.output);
    stop_if_interrupted();
  }
  if (arguments.settings.json) {
    Json report = field_json(arguments.input, input);
    report["output"] = arguments.output;
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
  verb->add_option("-o,--output", arguments->output, "Field to write (.cdfr)")->required()->type_name("FILE");
  verb->add_flag("--compress", arguments->compress,
                 "Pack the file (zstd), for archives: it is read into memory whole, not mapped");
  add_field_options(*verb, arguments->settings);
  verb->footer("Example:\n  cdfr build part.stl -o part.cdfr --unit mm");
  verb->callback([arguments] { build(*arguments); });
}

}  // namespace cdfr::command
