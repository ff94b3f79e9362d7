#include "contour_surface.h"

#include <algorithm>
#include <chrono>
#include <cstddef>

#include "audit_report.h"
#include "byte_sink.h"
#include "cdfr/contour/mesh.h"
#include "cdfr/export/write.h"
#include "field_report.h"
#include "json_report.h"
#include "number_text.h"
#include "output_target.h"
#include "steering.h"
#include "stop.h"
#include "terminal_text.h"
#include "text_report.h"
#include "unit.h"

namespace cdfr::command {
namespace {

/// What a report for people names of each doubt.
constexpr std::size_t places_told = 5;

const char* doubt_text(ContourDoubt doubt) {
  switch (doubt) {
    case ContourDoubt::crowded:
      return "crowded";
    case ContourDoubt::undecided:
      return "undecided";
    case ContourDoubt::loose:
      return "loose";
  }
  return "";
}

Json places_json(const ContourMeshReport& report) {
  Json places = Json::array();
  for (const ContourPlace& place : report.places) {
    places.push_back(
        {{"doubt", doubt_text(place.doubt)}, {"position", json_of(place.position)}, {"size", place.size}});
  }
  return places;
}

Json surface_json(const SurfaceRequest& request, const Input& input, const ContourMeshReport& report,
                  double seconds) {
  Json json = begin_field_report(request.input, input);
  json["distance"] = request.distance;
  json["tolerance"] = report.tolerance;
  json["triangles"] = report.triangles;
  json["vertices"] = report.vertices;
  json["cells"] = report.cells;
  json["smallest_cell"] = report.smallest_cell;
  json["evaluations"] = report.evaluations;
  json["crowded"] = report.crowded;
  json["undecided"] = report.undecided;
  json["loose"] = report.loose;
  json["places"] = places_json(report);
  json["largest_error"] = report.largest_error;
  json["part_itself"] = report.part_itself;
  json["box"] = report.vertices > 0 ? json_of(report.box) : Json(nullptr);
  json["seconds"] = seconds;
  json["field_seconds"] = input.seconds;
  json["output"] = request.output;
  return json;
}

void add_doubts(const ContourMeshReport& report, const std::string& unit, TextReport& text) {
  const auto told = [&](const char* label, std::uint64_t count, const char* what) {
    if (count > 0) text.line(label, count_text(count) + " cells: " + what);
  };
  told("crowded", report.crowded, "several sheets of the surface in one");
  told("undecided", report.undecided, "something thinner than they may be missing");
  told("loose", report.loose, "farther from the contour than the tolerance");
  for (std::size_t i = 0; i < std::min(places_told, report.places.size()); ++i) {
    const ContourPlace& place = report.places[i];
    text.line(doubt_text(place.doubt), "at " + short_text(place.position) + unit);
  }
}

std::string surface_text(const SurfaceRequest& request, const Input& input, const ContourMeshReport& report,
                         double seconds) {
  const std::string unit = after_number(input.unit);
  TextReport text(request.title);
  if (report.triangles == 0) {
    text.line("triangles", "none: there is no such distance, or it bounds no volume");
  } else {
    text.line("triangles", count_text(report.triangles) + ", " + count_text(report.vertices) + " vertices");
    text.line("box", short_text(report.box.lo) + " to " + short_text(report.box.hi) + unit);
  }
  if (report.part_itself) text.line("surface", "the part's own");
  text.line("tolerance", short_text(report.tolerance) + unit);
  text.line("largest error seen", short_text(report.largest_error) + unit);
  add_doubts(report, unit, text);
  text.line("cells",
            count_text(report.cells) + ", the smallest ones " + short_text(report.smallest_cell) + unit);
  text.line("distances computed", count_text(report.evaluations));
  text.line("time", seconds_text(seconds) + ", field " + seconds_text(input.seconds));
  text.line("written to", terminal_text(request.output));
  return text.text();
}

}  // namespace

void check_surface_target(const std::string& output) { check_target(output, {".ply", ".stl", ".obj"}); }

void contour_surface(const SurfaceRequest& request, const Input& input) {
  const auto start = std::chrono::steady_clock::now();
  Steering steering(request.settings, "meshing");
  const ContourMesh contour =
      need(contour_mesh(input.field, request.distance, {request.tolerance}, steering.run()), request.input);
  stop_if_interrupted();
  need(write_mesh(contour.mesh.view(), request.output), request.output);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (request.settings.json) {
    print_json(surface_json(request, input, contour.report, seconds));
  } else if (!request.settings.quiet) {
    print_text(surface_text(request, input, contour.report, seconds));
  }
}

}  // namespace cdfr::command
