#include "cdfr/contour/contour.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "audit_report.h"
#include "byte_sink.h"
#include "cdfr/export/write.h"
#include "cdfr/mesh/read.h"
#include "cdfr/render/splat.h"
#include "choice_option.h"
#include "contour_surface.h"
#include "field_report.h"
#include "input.h"
#include "json_report.h"
#include "number_option.h"
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

const std::map<std::string, Rule> rules{{"closed", Rule::closed}, {"paper", Rule::paper}};

struct Arguments {
  std::string input, output, picture, part;
  double distance = 0, depth = 0, tolerance = 0;
  Rule rule = Rule::closed;
  bool mesh = false;
  const CLI::Option *distance_option = nullptr, *depth_option = nullptr;
  Settings settings;

  bool asks_depth() const { return depth_option->count() > 0; }
  double signed_distance() const { return asks_depth() ? -depth : distance; }
};

/// Points go to the file as they come, and are kept only if a picture will need them.
class Recorder final : public PointSink {
 public:
  Recorder(std::unique_ptr<PointFile> file, bool keep) : file_(std::move(file)), keep_(keep) {}

  Result<void> write(std::span<const ContourPoint> points) override {
    if (keep_) kept_.insert(kept_.end(), points.begin(), points.end());
    return file_ ? file_->write(points) : Result<void>();
  }
  Result<void> finish() { return file_ ? file_->finish() : Result<void>(); }
  std::span<const ContourPoint> kept() const { return kept_; }

 private:
  std::unique_ptr<PointFile> file_;
  bool keep_;
  std::vector<ContourPoint> kept_;
};

struct Contour {
  double distance = 0, tolerance = 0, seconds = 0;
  ContourReport report;
};

double default_tolerance(const Field& field) {
  const Box box = field.bounds();
  return std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z}) / 1000;
}

void check_arguments(const Arguments& arguments) {
  if (arguments.mesh && arguments.rule == Rule::paper)
    stop_usage("--rule paper is for points, not for --mesh");
  if (arguments.distance_option->count() + arguments.depth_option->count() != 1) {
    stop_usage("contour needs --distance or --depth, one of them");
  }
  if (arguments.mesh) {
    if (arguments.output.empty()) stop_usage("contour --mesh needs -o FILE");
    if (!arguments.picture.empty()) stop_usage("--picture shows points: not with --mesh");
    if (!arguments.part.empty()) stop_usage("--part means nothing without --picture");
    check_surface_target(arguments.output);
    return;
  }
  if (arguments.output.empty() && arguments.picture.empty()) {
    stop_usage("contour needs -o FILE, --picture IMAGE.png or both");
  }
  if (!arguments.part.empty() && arguments.picture.empty()) {
    stop_usage("--part means nothing without --picture");
  }
  if (!arguments.output.empty()) check_target(arguments.output, {".ply", ".glb", ".csv"});
  if (!arguments.picture.empty()) check_target(arguments.picture, {".png"});
}

/// Positions of a GLB are in metres by its standard.
double metres_per_unit(const Arguments& arguments, const std::string& unit) {
  if (extension_of(arguments.output) != ".glb") return 1;
  const auto metres = metres_in(unit);
  if (!metres && !unit.empty() && !arguments.settings.quiet) {
    std::fprintf(stderr, "note: unit '%s' has no known length, so the GLB takes it for a metre\n",
                 terminal_text(unit).c_str());
  }
  return metres.value_or(1);
}

Recorder open_recorder(const Arguments& arguments, const std::string& unit) {
  if (arguments.output.empty()) return {nullptr, true};
  auto file = need(create_point_file(arguments.output, metres_per_unit(arguments, unit)), arguments.output);
  return {std::move(file), !arguments.picture.empty()};
}

Contour extract(const Arguments& arguments, const Input& input, const Mesh& part) {
  const auto start = std::chrono::steady_clock::now();
  Contour contour;
  contour.distance = arguments.signed_distance();
  contour.tolerance = arguments.tolerance > 0 ? arguments.tolerance : default_tolerance(input.field);
  Steering steering(arguments.settings, "extracting");
  Recorder recorder = open_recorder(arguments, input.unit);
  const auto report = contour_points(input.field, contour.distance, {contour.tolerance, arguments.rule},
                                     recorder, steering.run());
  const bool at_output = !report && report.error().code == Code::file_write;
  contour.report = need(report, at_output ? arguments.output : arguments.input);
  if (!arguments.picture.empty()) {
    need(splat_png(recorder.kept(), part.view(), arguments.picture), arguments.picture);
  }
  stop_if_interrupted();
  need(recorder.finish(), arguments.output);
  contour.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return contour;
}

Json contour_json(const Arguments& arguments, const Input& input, const Contour& contour) {
  const ContourReport& report = contour.report;
  Json json = begin_field_report(arguments.input, input);
  json["distance"] = contour.distance;
  json["tolerance"] = contour.tolerance;
  json["rule"] = arguments.rule == Rule::paper ? "paper" : "closed";
  json["leaves"] = report.leaves;
  json["visited"] = report.visited;
  json["productive"] = report.productive;
  json["evaluations"] = report.evaluations;
  json["points"] = report.points;
  json["undecided"] = report.undecided;
  json["subvoxel"] = report.subvoxel;
  json["max_error"] = report.max_error;
  json["box"] = report.points > 0 ? json_of(report.box) : Json(nullptr);
  json["seconds"] = contour.seconds;
  json["field_seconds"] = input.seconds;
  json["output"] = arguments.output.empty() ? Json(nullptr) : Json(arguments.output);
  json["picture"] = arguments.picture.empty() ? Json(nullptr) : Json(arguments.picture);
  return json;
}

/// No point is an answer: as no crossing is ever missed, the contour is empty, and that says how far the part
/// reaches.
std::string nothing_found(const Input& input, const Contour& contour) {
  const std::string unit = after_number(input.unit);
  if (contour.distance >= 0) return "none: nowhere is the distance as asked";
  return "none: no point at this depth; no place inside is as deep as " + short_text(-contour.distance) +
         unit;
}

void add_findings(const Input& input, const ContourReport& report, TextReport& text) {
  const std::string unit = after_number(input.unit);
  text.line("points", count_text(report.points));
  text.line("box of the points", short_text(report.box.lo) + " to " + short_text(report.box.hi) + unit);
  text.line("largest error", short_text(report.max_error) + unit);
  text.line("smallest sub-voxel", short_text(report.subvoxel) + unit);
  if (report.undecided > 0) {
    text.line("undecided", count_text(report.undecided) + " points, each within its own error");
  }
}

std::string title_of(const Arguments& arguments, const Input& input) {
  const std::string unit = after_number(input.unit);
  std::string title = "contour of " + terminal_text(arguments.input) + " at distance " +
                      short_text(arguments.signed_distance()) + unit;
  if (arguments.asks_depth()) title += " (depth " + short_text(arguments.depth) + unit + ")";
  return title;
}

std::string contour_text(const Arguments& arguments, const Input& input, const Contour& contour) {
  const ContourReport& report = contour.report;
  const std::string unit = after_number(input.unit);
  TextReport text(title_of(arguments, input));
  if (report.points > 0) {
    add_findings(input, report, text);
  } else {
    text.line("points", nothing_found(input, contour));
  }
  text.line("tolerance", short_text(contour.tolerance) + unit);
  text.line("leaves", count_text(report.leaves) + ": " + count_text(report.visited) + " visited, " +
                          count_text(report.productive) + " gave points");
  text.line("distances computed", count_text(report.evaluations));
  text.line("time", seconds_text(contour.seconds) + ", field " + seconds_text(input.seconds));
  if (!arguments.output.empty()) text.line("written to", terminal_text(arguments.output));
  if (!arguments.picture.empty()) text.line("picture", terminal_text(arguments.picture));
  return text.text();
}

void contour_input(const Arguments& arguments) {
  check_arguments(arguments);
  std::optional<Mesh> part;
  if (!arguments.part.empty()) part = need(read_mesh(arguments.part), arguments.part);
  const bool inside = arguments.asks_depth() || arguments.signed_distance() < 0;
  const Input input =
      open_input(arguments.input, arguments.settings, inside ? Demand::inside : Demand::any_field);
  if (arguments.mesh) {
    contour_surface({arguments.input, arguments.output, arguments.signed_distance(), arguments.tolerance,
                     title_of(arguments, input), arguments.settings},
                    input);
    return;
  }
  const Mesh none;
  const Contour contour = extract(arguments, input, part ? *part : input.mesh ? *input.mesh : none);
  if (arguments.settings.json) {
    print_json(contour_json(arguments, input, contour));
  } else if (!arguments.settings.quiet) {
    print_text(contour_text(arguments, input, contour));
  }
}

}  // namespace

void add_contour(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb =
      program.add_subcommand("contour", "A contour of the signed distance, as points or as a mesh");
  verb->add_option("INPUT", arguments->input, "Saved field, or a mesh that is built first")->required();
  arguments->distance_option =
      add_number(*verb, "--distance", arguments->distance, {}, "Signed distance, negative inside");
  arguments->depth_option =
      add_number(*verb, "--depth", arguments->depth, {}, "Depth below the surface: --distance of -T");
  add_number(*verb, "--tolerance", arguments->tolerance, {std::numeric_limits<double>::min()},
             "Largest distance from any point of the contour to what is found (longest side / 1000)");
  add_choice(*verb, "--rule", arguments->rule, rules,
             "Which sub-voxels give points: closed (no hole, no ghost) or paper (the source paper's, for "
             "comparison)");
  verb->add_flag("--mesh", arguments->mesh, "A closed surface of triangles instead of points");
  verb->add_option("-o,--output", arguments->output,
                   "Points (.ply, .glb, .csv), or the mesh (.ply, .stl, .obj)")
      ->type_name("FILE");
  verb->add_option("--picture", arguments->picture,
                   "Picture of the points, the part faint around them (.png)")
      ->type_name("FILE");
  verb->add_option("--part", arguments->part, "Mesh to draw in the picture, if INPUT is a saved field")
      ->type_name("MESH");
  add_field_options(*verb, arguments->settings);
  verb->footer(
      "Example:\n  cdfr contour part.stl --depth 8.5 --tolerance 0.2 -o deep.ply --picture deep.png\n"
      "  cdfr contour part.stl --distance 2 --mesh -o grown.stl");
  verb->callback([arguments] { contour_input(*arguments); });
}

}  // namespace cdfr::command
