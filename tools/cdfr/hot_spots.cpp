#include "hot_spots.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <utility>

#include "ball_drawing.h"
#include "byte_sink.h"
#include "hot_spots_report.h"
#include "output_target.h"
#include "patch_number.h"
#include "steering.h"
#include "stop.h"

namespace cdfr::command {
namespace {

void write(const HotSpotsRequest& request, const Input& input, const HotSpotsFinding& finding) {
  if (request.output.empty()) return;
  if (is_drawn(request.output)) {
    std::vector<DrawnBall> balls;
    for (const HotSpot& spot : finding.found.spots) balls.push_back({&spot.ball, spot.ball.touches});
    const double least = balls.empty() ? 0 : 2 * balls.back().ball->radius;
    return draw_balls(drawn_mesh(request.part, input), balls, least, input.unit, finding.provenance,
                      request.output);
  }
  const auto sink = whole_file(request.output);
  sink->write(extension_of(request.output) == ".csv" ? hot_spots_csv(finding.found)
                                                     : text_of(hot_spots_json(request, input, finding)));
  stop_if_interrupted();
  sink->finish();
}

}  // namespace

void hot_spots_of_input(HotSpotsRequest request, const CLI::App& verb) {
  const Input input = open_input(request.input, request.settings, Demand::inside);
  request.options.feeders = patch_numbers("--feed", request.feeders, input);
  const auto start = std::chrono::steady_clock::now();
  Steering steering(request.settings, "looking for hot spots");
  HotSpotsFinding finding;
  finding.found = need(hot_spots(input.field, request.options, steering.run()), request.input);
  finding.provenance = provenance_of(request.input, verb, input);
  finding.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write(request, input, finding);
  stop_if_interrupted();
  if (request.settings.json) {
    print_json(hot_spots_json(request, input, finding));
  } else if (!request.settings.quiet) {
    print_text(hot_spots_text(request, input, finding));
  }
}

}  // namespace cdfr::command
