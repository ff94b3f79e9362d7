#include "hot_spots_report.h"

#include <algorithm>
#include <cmath>

#include "audit_report.h"
#include "field_report.h"
#include "number_text.h"
#include "sections_report.h"
#include "terminal_text.h"
#include "text_report.h"
#include "unit.h"

namespace cdfr::command {
namespace {

/// How many a report for people lists.
constexpr std::size_t spots_told = 20;

Json neck_json(const Neck& neck) {
  return {{"center", json_of(neck.centre)}, {"radius", neck.radius}, {"error", neck.error}};
}

Json spot_json(const HotSpot& spot, std::size_t place) {
  const bool has_neck = spot.towards != HotSpot::none;
  return {{"rank", place + 1},
          {"ball", ball_json(spot.ball)},
          {"prominence", spot.prominence},
          {"towards", has_neck ? Json(spot.towards + 1) : Json(nullptr)},
          {"neck", has_neck ? neck_json(spot.neck) : Json(nullptr)},
          {"wall", spot.wall},
          {"isolation", spot.isolation},
          {"fed", spot.fed},
          {"feed", spot.fed ? neck_json(spot.feed) : Json(nullptr)}};
}

/// "ball of 5.0 mm +- 0.1 at ...".
std::string neck_text(const Neck& neck, const std::string& unit) {
  return bounded_text(2 * neck.radius, 2 * neck.error, unit) + " at " + short_text(neck.centre);
}

std::string isolation_text(const HotSpot& spot, double error, const std::string& unit) {
  if (!(spot.wall > 0)) return "no wall leads away";
  return short_text(std::round(spot.isolation * 100) / 100) + " times the walls around it (" +
         bounded_text(2 * spot.wall, 2 * error, unit) + ")";
}

void add_spot(const HotSpotsRequest& request, const Input& input, const HotSpots& found, std::size_t place,
              TextReport& text) {
  const HotSpot& spot = found.spots[place];
  text.line(std::to_string(place + 1),
            thickness_text(spot.ball, input.unit) + ", at " + short_text(spot.ball.centre));
  text.line("", isolation_text(spot, found.error, input.unit));
  if (spot.towards != HotSpot::none) {
    text.line("",
              "neck towards " + std::to_string(spot.towards + 1) + ": " + neck_text(spot.neck, input.unit));
  }
  if (request.options.feeders.empty()) return;
  text.line("", spot.fed ? "fed through " + neck_text(spot.feed, input.unit) : "not fed");
}

void append_neck(std::string& text, const Neck& neck, bool is_there) {
  for (const double value : {neck.centre.x, neck.centre.y, neck.centre.z, neck.radius}) {
    text += ',';
    if (is_there) append_exact(text, value);
  }
}

void append_row(std::string& text, const HotSpot& spot, std::size_t rank) {
  text += std::to_string(rank);
  for (const double value :
       {spot.ball.centre.x, spot.ball.centre.y, spot.ball.centre.z, spot.ball.radius, 2 * spot.ball.radius,
        spot.ball.error, spot.prominence, spot.wall, spot.isolation}) {
    text += ',';
    append_exact(text, value);
  }
  const bool has_neck = spot.towards != HotSpot::none;
  text += "," + (has_neck ? std::to_string(spot.towards + 1) : "");
  append_neck(text, spot.neck, has_neck);
  append_neck(text, spot.feed, spot.fed);
  text += '\n';
}

}  // namespace

Json hot_spots_json(const HotSpotsRequest& request, const Input& input, const HotSpotsFinding& finding) {
  const HotSpots& found = finding.found;
  Json json = begin_field_report(request.input, input);
  json["error"] = found.error;
  json["prominence"] = found.prominence;
  json["feeders"] = request.options.feeders;
  json["hot_spots"] = Json::array();
  for (std::size_t i = 0; i < found.spots.size(); ++i)
    json["hot_spots"].push_back(spot_json(found.spots[i], i));
  json["critical_cells"] = found.critical_cells;
  json["provenance"] = json_of(finding.provenance);
  json["seconds"] = finding.seconds;
  json["field_seconds"] = input.seconds;
  json["output"] = request.output.empty() ? Json(nullptr) : Json(request.output);
  return json;
}

std::string hot_spots_text(const HotSpotsRequest& request, const Input& input,
                           const HotSpotsFinding& finding) {
  const HotSpots& found = finding.found;
  const std::string unit = after_number(input.unit);
  TextReport text("hot spots of " + terminal_text(request.input));
  text.line("hot spots", found.spots.empty() ? "none of that prominence" : count_text(found.spots.size()));
  const std::size_t told = std::min(spots_told, found.spots.size());
  for (std::size_t i = 0; i < told; ++i) add_spot(request, input, found, i, text);
  if (told < found.spots.size())
    text.line("", "and " + count_text(found.spots.size() - told) + " lesser ones (--json has all)");
  text.line("prominence above", short_text(found.prominence) + unit);
  text.line("error of necks", short_text(found.error) + unit);
  add_mesh(input.field.report(), text);
  text.line("sha256 of the input", finding.provenance.sha256);
  text.line("time", seconds_text(finding.seconds) + ", field " + seconds_text(input.seconds));
  if (!request.output.empty()) text.line("written to", terminal_text(request.output));
  return text.text();
}

std::string hot_spots_csv(const HotSpots& found) {
  std::string text =
      "rank,x,y,z,radius,diameter,error,prominence,wall,isolation,towards,neck_x,neck_y,neck_z,neck_radius,"
      "feed_x,feed_y,feed_z,feed_radius\n";
  for (std::size_t i = 0; i < found.spots.size(); ++i) append_row(text, found.spots[i], i + 1);
  return text;
}

}  // namespace cdfr::command
