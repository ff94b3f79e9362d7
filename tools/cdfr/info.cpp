#include <memory>
#include <string>

#include "byte_sink.h"
#include "cdfr/store/store.h"
#include "field_report.h"
#include "input.h"
#include "steering.h"
#include "stop.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

struct Arguments {
  std::string input;
  bool verify = false;
  Settings settings;
};

/// Also says so.
void check(const Arguments& arguments) {
  if (!is_saved_field(arguments.input))
    stop_usage("--verify means nothing here: '" + arguments.input + "' is a mesh");
  Steering steering(arguments.settings, "verifying");
  need(verify(arguments.input, steering.run()), arguments.input);
}

void info(const Arguments& arguments) {
  if (arguments.verify) check(arguments);
  const Input input = open_input(arguments.input, arguments.settings);
  if (arguments.settings.json) {
    Json report = field_json(arguments.input, input);
    if (arguments.verify) report["verified"] = true;
    need(input.field.status(), arguments.input);
    print_json(report);
  } else {
    const std::string text = field_text(arguments.input, input);
    need(input.field.status(), arguments.input);
    print_text(text +
               (arguments.verify ? "verified: what a build of its mesh gives, to the last bit\n" : ""));
  }
}

}  // namespace

void add_info(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = program.add_subcommand("info", "Say what a field holds: leaves, lists, levels, checksum");
  verb->add_option("INPUT", arguments->input, "Saved field, or a mesh that is built first")->required();
  verb->add_flag("--verify", arguments->verify,
                 "Check every byte of a saved field: checksums, then what a build of its mesh gives");
  add_field_options(*verb, arguments->settings);
  verb->footer("Example:\n  cdfr info part.cdfr --json");
  verb->callback([arguments] { info(*arguments); });
}

}  // namespace cdfr::command
