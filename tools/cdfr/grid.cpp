#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "audit_report.h"
#include "cdfr/field/grid.h"
#include "field_report.h"
#include "grid_file.h"
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

constexpr int most_samples = 8192;
/// Planes are answered and written in slabs of so many samples, 64 MB, or of one plane if that has more.
constexpr std::size_t slab_samples = std::size_t{1} << 23;

struct Arguments {
  std::string input, output;
  int resolution = 0;
  Settings settings;
};

struct Summary {
  std::uint64_t inside = 0;
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  double seconds = 0;

  void add(std::span<const double> distances) {
    for (const double d : distances) {
      inside += d < 0;
      least = std::min(least, d);
      greatest = std::max(greatest, d);
    }
  }
};

/// From the box's lower corner, as wide in all directions: `resolution` samples along the longest side, and
/// as many as cover the others. The last bits of a quotient are no reason for one more.
Grid grid_over(const Box& box, int resolution) {
  const double sides[3] = {box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z};
  const double longest = *std::max_element(sides, sides + 3);
  const double spacing = longest / (resolution - 1);
  Grid grid{box.lo, {spacing, spacing, spacing}, {1, 1, 1}};
  for (int axis = 0; axis < 3 && spacing > 0; ++axis) {
    grid.size[axis] = 1 + static_cast<std::uint32_t>(std::ceil(sides[axis] / spacing * (1 - 0x1p-40)));
  }
  return grid;
}

/// Slab after slab, so that memory does not grow with the grid.
Summary answer(const Arguments& arguments, const Field& field, const Grid& grid) {
  const auto start = std::chrono::steady_clock::now();
  Steering steering(arguments.settings, "sampling");
  GridFile file(grid, arguments.output);
  Summary summary;
  const std::size_t plane = std::size_t{grid.size[0]} * grid.size[1];
  const auto thickness = static_cast<std::uint32_t>(std::max<std::size_t>(slab_samples / plane, 1));
  std::vector<double> distances;
  for (Grid slab = grid; slab.first[2] < grid.size[2]; slab.first[2] += slab.size[2]) {
    slab.size[2] = std::min(thickness, grid.size[2] - slab.first[2]);
    distances.resize(slab.count());
    const double planes = grid.size[2];
    steering.share(slab.first[2] / planes, (slab.first[2] + slab.size[2]) / planes);
    need(field.distance(slab, distances, steering.run()), arguments.input);
    file.write(distances);
    summary.add(distances);
  }
  file.finish();
  stop_if_interrupted();
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return summary;
}

Json grid_json(const Arguments& arguments, const Input& input, const Grid& grid, const Summary& summary) {
  Json report = begin_field_report(arguments.input, input);
  report["grid"] = {
      {"origin", json_of(grid.origin)}, {"spacing", json_of(grid.spacing)}, {"size", grid.size}};
  report["samples"] = grid.count();
  report["inside"] = summary.inside;
  report["distance"] = {{"min", summary.least}, {"max", summary.greatest}};
  report["seconds"] = summary.seconds;
  report["field_seconds"] = input.seconds;
  report["output"] = arguments.output;
  return report;
}

std::string grid_text(const Arguments& arguments, const Input& input, const Grid& grid,
                      const Summary& summary) {
  TextReport report(count_text(grid.count()) + " samples of " + terminal_text(arguments.input));
  const auto [x, y, z] = grid.size;
  report.line("grid", count_text(x) + " x " + count_text(y) + " x " + count_text(z));
  report.line("spacing", short_text(grid.spacing.x) + after_number(input.unit));
  report.line("sign", sign_text(input.field.sign()));
  report.line("inside", count_text(summary.inside));
  report.line("distance",
              short_text(summary.least) + " to " + short_text(summary.greatest) + after_number(input.unit));
  report.line("time", seconds_text(summary.seconds));
  report.line("written to", terminal_text(arguments.output));
  return report.text();
}

void grid(const Arguments& arguments) {
  check_target(arguments.output, {".npy", ".vti"});
  const Input input = open_input(arguments.input, arguments.settings);
  const Grid grid = grid_over(input.field.bounds(), arguments.resolution);
  const Summary summary = answer(arguments, input.field, grid);
  if (arguments.settings.json) {
    print_json(grid_json(arguments, input, grid, summary));
  } else if (!arguments.settings.quiet) {
    print_text(grid_text(arguments, input, grid, summary));
  }
}

}  // namespace

void add_grid(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = program.add_subcommand("grid", "Distances at the points of a regular grid");
  verb->add_option("INPUT", arguments->input, "Saved field, or a mesh that is built first")->required();
  add_count(*verb, "--resolution", arguments->resolution, 2, most_samples,
            "Samples along the longest side of the mesh's box")
      ->required();
  verb->add_option("-o,--output", arguments->output, "Distances (.npy, .vti)")->required()->type_name("FILE");
  add_field_options(*verb, arguments->settings);
  verb->footer("Example:\n  cdfr grid part.cdfr --resolution 256 -o distances.vti");
  verb->callback([arguments] { grid(*arguments); });
}

}  // namespace cdfr::command
