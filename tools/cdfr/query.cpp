#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "answer_table.h"
#include "audit_report.h"
#include "byte_sink.h"
#include "cdfr/mesh/read.h"
#include "field_report.h"
#include "input.h"
#include "json_report.h"
#include "number_text.h"
#include "output_target.h"
#include "steering.h"
#include "stop.h"
#include "terminal_text.h"
#include "text_report.h"
#include "unit.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

/// Answers in memory at a time.
constexpr std::size_t block_points = 65536;

struct Arguments {
  std::string input, points, output = "-";
  Settings settings;

  bool to_standard_output() const { return output == "-"; }
};

struct Summary {
  std::uint64_t points = 0, inside = 0;
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  double seconds = 0;

  void add(std::span<const Closest> answers) {
    points += answers.size();
    for (const Closest& answer : answers) {
      inside += answer.distance < 0;
      least = std::min(least, answer.distance);
      greatest = std::max(greatest, answer.distance);
    }
  }
};

Summary answer(const Arguments& arguments, const Field& field, std::span<const Vec3> points) {
  Summary summary;
  Steering steering(arguments.settings, "asking");
  const bool to_screen = arguments.to_standard_output();
  const auto sink = to_screen ? standard_output() : whole_file(arguments.output);
  const auto table = answer_table(to_screen ? ".csv" : extension_of(arguments.output));
  table->begin(*sink, points.size());
  std::vector<Closest> answers;
  for (std::size_t first = 0; first < points.size(); first += block_points) {
    const auto block = points.subspan(first, std::min(block_points, points.size() - first));
    const auto all = static_cast<double>(points.size());
    steering.share(static_cast<double>(first) / all, static_cast<double>(first + block.size()) / all);
    answers.resize(block.size());
    need(field.closest(Points(block), answers, steering.run()), arguments.input);
    table->append(*sink, block, answers);
    summary.add(answers);
    stop_if_interrupted();
  }
  sink->finish();
  stop_if_interrupted();
  return summary;
}

Json query_json(const Arguments& arguments, const Input& input, const Summary& summary) {
  Json report = begin_field_report(arguments.input, input);
  report["points"] = summary.points;
  report["inside"] = summary.inside;
  report["distance"] = nullptr;
  if (summary.points > 0) report["distance"] = {{"min", summary.least}, {"max", summary.greatest}};
  report["seconds"] = summary.seconds;
  report["field_seconds"] = input.seconds;
  report["output"] = arguments.output;
  return report;
}

std::string query_text(const Arguments& arguments, const Input& input, const Summary& summary) {
  TextReport report(count_text(summary.points) + " points asked of " + terminal_text(arguments.input));
  report.line("sign", sign_text(input.field.sign()));
  report.line("inside", count_text(summary.inside));
  if (summary.points > 0) {
    report.line("distance",
                short_text(summary.least) + " to " + short_text(summary.greatest) + after_number(input.unit));
  }
  report.line("time", seconds_text(summary.seconds));
  report.line("written to", terminal_text(arguments.output));
  return report.text();
}

void query(const Arguments& arguments) {
  const Settings& settings = arguments.settings;
  if (arguments.to_standard_output() && settings.json) {
    stop_usage("query --json needs -o FILE: without it standard output has the table");
  }
  if (!arguments.to_standard_output()) check_target(arguments.output, {".csv", ".npy", ".ply"});
  const std::vector<Vec3> points = need(read_points(arguments.points), arguments.points);
  const Input input = open_input(arguments.input, settings);
  const auto start = std::chrono::steady_clock::now();
  Summary summary = answer(arguments, input.field, points);
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (settings.json) {
    print_json(query_json(arguments, input, summary));
  } else if (!settings.quiet && !arguments.to_standard_output()) {
    print_text(query_text(arguments, input, summary));
  }
}

}  // namespace

void add_query(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb =
      program.add_subcommand("query", "Distance, closest point, gradient, triangle and feature of points");
  verb->add_option("INPUT", arguments->input, "Saved field, or a mesh that is built first")->required();
  verb->add_option("--points", arguments->points, "Points (.csv, .npy, .ply); - is CSV on standard input")
      ->required()
      ->type_name("FILE");
  verb->add_option("-o,--output", arguments->output,
                   "Answers (.csv, .npy, .ply); - is CSV on standard output")
      ->type_name("FILE");
  add_field_options(*verb, arguments->settings);
  verb->footer("Example:\n  cdfr query part.cdfr --points probes.csv -o answers.csv");
  verb->callback([arguments] { query(*arguments); });
}

}  // namespace cdfr::command
