#include <memory>
#include <string>

#include "byte_sink.h"
#include "field_report.h"
#include "input.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

struct Arguments {
  std::string input;
  Settings settings;
};

void info(const Arguments& arguments) {
  const Input input = open_input(arguments.input, arguments.settings);
  if (arguments.settings.json) {
    print_json(field_json(arguments.input, input));
  } else {
    print_text(field_text(arguments.input, input));
  }
}

}  // namespace

void add_info(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = program.add_subcommand("info", "Say what a field holds: leaves, lists, levels, checksum");
  verb->add_option("INPUT", arguments->input, "Saved field, or a mesh that is built first")->required();
  add_field_options(*verb, arguments->settings);
  verb->footer("Example:\n  cdfr info part.cdfr --json");
  verb->callback([arguments] { info(*arguments); });
}

}  // namespace cdfr::command
