#include "thickness_report.h"

#include <algorithm>
#include <cstddef>

#include "audit_report.h"
#include "field_report.h"
#include "number_text.h"
#include "terminal_text.h"
#include "text_report.h"
#include "thickness_words.h"
#include "unit.h"

namespace cdfr::command {
namespace {

/// What a report for people names of each list.
constexpr std::size_t places_told = 5;

Json facet_json(const ThicknessRequest& request, const ThicknessReport& report) {
  const FacetEstimate& estimate = report.facet_estimate;
  return {{"tolerance", report.facet},
          {"estimated", request.options.facet < 0 && request.options.method == ThicknessMethod::sphere},
          {"median", estimate.median},
          {"quantile", estimate.quantile},
          {"largest", estimate.largest},
          {"curved_triangles", estimate.curved_triangles}};
}

Json statistics_json(const ThicknessReport& report) {
  return {{"min", report.min}, {"p1", report.p1},    {"p5", report.p5},   {"p25", report.p25},
          {"p50", report.p50}, {"p75", report.p75},  {"p95", report.p95}, {"p99", report.p99},
          {"max", report.max}, {"mean", report.mean}};
}

Json places_json(const ThicknessReport& report) {
  Json places = Json::array();
  for (const ThinPlace& place : report.places) {
    places.push_back({{"rank", places.size() + 1},
                      {"position", json_of(place.position)},
                      {"thickness", place.thickness},
                      {"error", place.error},
                      {"facet", place.facet},
                      {"area", place.area},
                      {"triangle", place.triangle},
                      {"samples", place.samples},
                      {"at_edge", place.at_edge},
                      {"opposed", place.opposed}});
  }
  return places;
}

Json thinning_json(const std::string& against, const Thinning& thinning) {
  Json places = Json::array();
  for (const ThinnedPlace& place : thinning.places) {
    places.push_back({{"rank", places.size() + 1},
                      {"position", json_of(place.position)},
                      {"thickness", place.thickness},
                      {"former", place.former},
                      {"error", place.error},
                      {"area", place.area},
                      {"triangle", place.triangle},
                      {"samples", place.samples}});
  }
  return {{"former", against},           {"reach", thinning.reach},
          {"change", thinning.change},   {"compared", thinning.compared},
          {"at_edge", thinning.at_edge}, {"unmatched", thinning.unmatched},
          {"area", thinning.area},       {"places", places}};
}

void add_options(const ThicknessRequest& request, const ThicknessReport& report, Json& json) {
  const ThicknessOptions& options = request.options;
  json["method"] = method_word(options.method);
  json["at"] = at_word(options.at);
  json["spacing"] = options.at == SampleAt::spacing ? Json(options.spacing) : Json(nullptr);
  json["clearance"] = options.clearance;
  json["facet"] = facet_json(request, report);
  json["sharp"] = options.sharp;
  json["edges"] = edges_word(options.edges);
  json["error"] = report.error;
  json["rounding"] = report.rounding;
  json["largest"] = report.largest;
  json["cone"] = options.cone;
  json["rays"] = options.rays;
}

/// The divergence theorem's volume is that of a solid only where the mesh closes.
void add_solid(const ThicknessRequest& request, const MeshReport& mesh, Json& json) {
  json["volume"] = mesh.embedded() ? Json(mesh.volume) : Json(nullptr);
  json["density"] = request.density > 0 ? Json(request.density) : Json(nullptr);
  const bool has_mass = request.density > 0 && mesh.embedded();
  json["mass"] = has_mass ? Json(mesh.volume * request.density) : Json(nullptr);
}

std::string about(double value, const ThicknessReport& report, const Input& input) {
  return bounded_text(value, report.error + report.facet, input.unit);
}

std::string squared(double area, const Input& input) {
  return short_text(area) + (input.unit.empty() ? "" : after_number(input.unit) + "^2");
}

void add_statistics(const Input& input, const ThicknessReport& report, TextReport& text) {
  text.line("least", about(report.min, report, input));
  text.line("5 % of the area below", about(report.p5, report, input));
  text.line("half of the area below", about(report.p50, report, input));
  text.line("95 % of the area below", about(report.p95, report, input));
  text.line("greatest", about(report.max, report, input));
  text.line("mean", about(report.mean, report, input));
}

void add_tolerances(const ThicknessRequest& request, const Input& input, const ThicknessReport& report,
                    TextReport& text) {
  const std::string unit = after_number(input.unit);
  text.line("engine's error", short_text(report.error) + unit);
  if (request.options.method == ThicknessMethod::ray) return;
  const FacetEstimate& estimate = report.facet_estimate;
  std::string how = short_text(report.facet) + unit;
  if (request.options.facet < 0 && estimate.curved_triangles == 0) how = "none: no triangle is curved";
  if (request.options.facet < 0 && estimate.curved_triangles > 0) {
    how = "up to " + how + ", on plane faces none: the chord error around each sample (" +
          count_text(estimate.curved_triangles) + " curved triangles, median " + short_text(estimate.median) +
          unit + ")";
  }
  text.line("facet tolerance", how);
}

void add_samples(const ThicknessRequest& request, const ThicknessReport& report, TextReport& text) {
  text.line("samples", count_text(report.samples));
  if (report.unmet > 0) text.line("nothing met by", count_text(report.unmet));
  if (report.skipped > 0) text.line("skipped at edges", count_text(report.skipped));
  if (request.options.edges != EdgePolicy::skip)
    text.line("held by design edges", count_text(report.at_edge));
  if (request.options.edges == EdgePolicy::extrapolate)
    text.line("of those extrapolated", count_text(report.extrapolated));
  text.line("smooth regions", count_text(report.regions));
}

/// Why a place is no thin wall, if it is none.
std::string held_text(const ThinPlace& place) {
  if (place.at_edge) return ", at a design edge";
  return place.opposed ? "" : ", held from its own side";
}

void add_places(const ThicknessRequest& request, const Input& input, const ThicknessReport& report,
                TextReport& text) {
  const std::string limit = short_text(report.thin_limit) + after_number(input.unit);
  const bool given = request.options.thinner_than > 0;
  text.line(given ? "thinner than " + limit : "thinnest walls",
            (given ? "" : "5 % of the wall's area is at most " + limit + "; so are ") +
                squared(report.thin_area, input) + " in all, " + squared(report.thin_wall_area, input) +
                " of it walls");
  text.line("thin places", count_text(report.place_count));
  for (std::size_t i = 0; i < std::min(places_told, report.places.size()); ++i) {
    const ThinPlace& place = report.places[i];
    text.line("  " + std::to_string(i + 1),
              bounded_text(place.thickness, place.error + place.facet, input.unit) + " at " +
                  short_text(place.position) + ", " + squared(place.area, input) + ", " +
                  count_text(place.samples) + " samples" + held_text(place));
  }
}

void add_thinning(const ThicknessRequest& request, const Input& input, const Thinning& thinning,
                  TextReport& text) {
  text.line("against", terminal_text(request.against));
  text.line("compared", count_text(thinning.compared) + " samples; " + count_text(thinning.unmatched) +
                            " have no former wall within " + short_text(thinning.reach) +
                            after_number(input.unit));
  const std::string by =
      thinning.change > 0 ? short_text(thinning.change) + after_number(input.unit) : "the tolerances of both";
  text.line("thinned", std::to_string(thinning.places.size()) + " places, " + squared(thinning.area, input) +
                           ", by more than " + by);
  for (std::size_t i = 0; i < std::min(places_told, thinning.places.size()); ++i) {
    const ThinnedPlace& place = thinning.places[i];
    text.line("  " + std::to_string(i + 1),
              bounded_text(place.thickness, place.error, input.unit) + ", was " +
                  bounded_text(place.former, place.error, input.unit) + ", at " + short_text(place.position) +
                  ", " + squared(place.area, input));
  }
}

std::string title_of(const ThicknessRequest& request) {
  const ThicknessOptions& options = request.options;
  const std::string what = options.clearance ? "clearance around " : "wall thickness of ";
  return what + terminal_text(request.input) + " by the " + method_word(options.method) + " method, at " +
         at_word(options.at);
}

}  // namespace

Json thickness_json(const ThicknessRequest& request, const Input& input, const ThicknessFinding& finding) {
  const ThicknessReport& report = finding.walls.report;
  Json json = begin_field_report(request.input, input);
  add_options(request, report, json);
  json["samples"] = report.samples;
  json["unmet"] = report.unmet;
  json["skipped"] = report.skipped;
  json["at_edge"] = report.at_edge;
  json["extrapolated"] = report.extrapolated;
  json["regions"] = report.regions;
  json["queries"] = report.queries;
  json["area"] = report.area;
  json["thickness"] = statistics_json(report);
  json["histogram"] = {{"min", report.min}, {"max", report.max}, {"area", report.histogram}};
  json["thin"] = {{"limit", report.thin_limit},
                  {"given", request.options.thinner_than > 0},
                  {"area", report.thin_area},
                  {"wall_area", report.thin_wall_area}};
  json["places"] = places_json(report);
  json["place_count"] = report.place_count;
  add_solid(request, input.field.report(), json);
  json["against"] = finding.thinning ? thinning_json(request.against, *finding.thinning) : Json(nullptr);
  json["provenance"] = json_of(finding.provenance);
  json["seconds"] = finding.seconds;
  json["field_seconds"] = input.seconds;
  json["output"] = request.output.empty() ? Json(nullptr) : Json(request.output);
  return json;
}

std::string thickness_text(const ThicknessRequest& request, const Input& input,
                           const ThicknessFinding& finding) {
  const ThicknessReport& report = finding.walls.report;
  const MeshReport& mesh = input.field.report();
  TextReport text(title_of(request));
  if (report.samples == 0) {
    text.line("samples", "none that met anything");
  } else {
    add_statistics(input, report, text);
    add_places(request, input, report, text);
  }
  if (finding.thinning) add_thinning(request, input, *finding.thinning, text);
  add_tolerances(request, input, report, text);
  add_samples(request, report, text);
  add_mesh(mesh, text);
  if (mesh.embedded()) {
    text.line("volume",
              short_text(mesh.volume) + (input.unit.empty() ? "" : after_number(input.unit) + "^3"));
    if (request.density > 0) text.line("mass", short_text(mesh.volume * request.density));
  }
  text.line("surface", squared(mesh.area, input));
  text.line("sha256 of the input", finding.provenance.sha256);
  text.line("time", seconds_text(finding.seconds) + ", field " + seconds_text(input.seconds));
  if (!request.output.empty()) text.line("written to", terminal_text(request.output));
  return text.text();
}

}  // namespace cdfr::command
