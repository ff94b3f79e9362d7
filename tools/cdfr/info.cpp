#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "byte_sink.h"
#include "cdfr/store/store.h"
#include "field_report.h"
#include "input.h"
#include "number_text.h"
#include "steering.h"
#include "stop.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

struct Arguments {
  std::string input;
  bool verify = false, deepest = false;
  Settings settings;
};

/// Also says so.
void check(const Arguments& arguments) {
  if (!is_saved_field(arguments.input))
    stop_usage("--verify means nothing here: '" + arguments.input + "' is a mesh");
  Steering steering(arguments.settings, "verifying");
  need(verify(arguments.input, steering.run()), arguments.input);
}

Deepest deepest_of(const Arguments& arguments, const Input& input) {
  Steering steering(arguments.settings, "looking for the deepest point");
  const Deepest deepest = need(input.field.deepest(0, steering.run()), arguments.input);
  stop_if_interrupted();
  return deepest;
}

std::string deepest_text(const Deepest& d, const std::string& unit) {
  return "deepest: " + bounded_text(d.depth, d.error, unit) +
         (d.depth > 0 ? " at " + short_text(d.point) : ", no point inside") + "\n";
}

Json deepest_json(const Deepest& d) {
  return {{"depth", d.depth}, {"error", d.error}, {"point", json_of(d.point)}};
}

void info(const Arguments& arguments) {
  if (arguments.verify) check(arguments);
  const Input input =
      open_input(arguments.input, arguments.settings, arguments.deepest ? Demand::inside : Demand::any_field);
  if (arguments.settings.json) {
    Json report = field_json(arguments.input, input);
    if (arguments.deepest) report["deepest"] = deepest_json(deepest_of(arguments, input));
    if (arguments.verify) report["verified"] = true;
    need(input.field.status(), arguments.input);
    print_json(report);
  } else {
    std::string text = field_text(arguments.input, input);
    if (arguments.deepest) text += deepest_text(deepest_of(arguments, input), input.unit);
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
  verb->add_flag("--deepest", arguments->deepest,
                 "Look for the deepest point inside too, to the longest side / 1000");
  add_field_options(*verb, arguments->settings);
  verb->footer("Example:\n  cdfr info part.cdfr --json");
  verb->callback([arguments] { info(*arguments); });
}

}  // namespace cdfr::command
