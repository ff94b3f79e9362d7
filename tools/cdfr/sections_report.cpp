#include "sections_report.h"

#include <algorithm>
#include <array>

#include "audit_report.h"
#include "field_report.h"
#include "number_text.h"
#include "terminal_text.h"
#include "text_report.h"
#include "unit.h"

namespace cdfr::command {
namespace {

/// How many sections a report for people lists.
constexpr std::size_t sections_told = 20;

constexpr std::array<const char*, 5> fates{"same", "grown", "shrunk", "new", "gone"};
const char* word_of(SectionFate fate) { return fates[static_cast<std::size_t>(fate)]; }

Json modulus_json(const Modulus* modulus) {
  if (modulus == nullptr) return nullptr;
  return {{"value", modulus->value},
          {"error", modulus->error},
          {"volume", modulus->volume},
          {"volume_error", modulus->volume_error},
          {"cooling_area", modulus->cooling_area}};
}

const Modulus* modulus_at(const SectionsFinding& finding, std::size_t place) {
  return finding.moduli.empty() ? nullptr : &finding.moduli[place];
}

Json section_json(const Section& section, const Modulus* modulus, std::size_t place) {
  return {{"rank", place + 1},
          {"ball", ball_json(section.ball)},
          {"volume", section.volume},
          {"volume_error", section.volume_error},
          {"area", section.area},
          {"area_error", section.area_error},
          {"modulus", modulus_json(modulus)},
          {"box", json_of(section.box)},
          {"cells", section.cells},
          {"triangles", section.triangles}};
}

Json joins_json(const Sections& sections) {
  Json joins = Json::array();
  for (const MayJoin& join : sections.may_join) {
    joins.push_back({{"first", join.first + 1},
                     {"second", join.second + 1},
                     {"place", json_of(join.place)},
                     {"depth", join.depth}});
  }
  return joins;
}

Json changes_json(const SectionsRequest& request, const SectionsFinding& finding) {
  if (!finding.former) return nullptr;
  Json changes = Json::array();
  for (const SectionChange& change : finding.changes) {
    Json one{{"fate", word_of(change.fate)},
             {"rank", change.now ? Json(*change.now + 1) : Json(nullptr)},
             {"former_rank", change.former ? Json(*change.former + 1) : Json(nullptr)}};
    one["former"] = change.former
                        ? section_json(finding.former->sections[*change.former], nullptr, *change.former)
                        : Json(nullptr);
    changes.push_back(one);
  }
  return {{"former", request.against}, {"changes", changes}};
}

/// The divergence theorem's volume is that of a solid only where the mesh closes.
void add_part(const SectionsRequest& request, const MeshReport& mesh, Json& json) {
  json["part"] = {{"volume", mesh.embedded() ? Json(mesh.volume) : Json(nullptr)}, {"area", mesh.area}};
  json["density"] = request.density > 0 ? Json(request.density) : Json(nullptr);
  const bool has_mass = request.density > 0 && mesh.embedded();
  json["mass"] = has_mass ? Json(mesh.volume * request.density) : Json(nullptr);
}

std::string power_of(const std::string& unit, const char* power) {
  return unit.empty() ? unit : unit + power;
}

void add_modulus(const Input& input, const Modulus* modulus, TextReport& text) {
  if (modulus == nullptr) return;
  if (!(modulus->cooling_area > 0)) return text.line("", "modulus infinite: nothing cools");
  text.line("", "modulus " + bounded_text(modulus->value, modulus->error, input.unit) + ": volume " +
                    bounded_text(modulus->volume, modulus->volume_error, power_of(input.unit, "^3")) +
                    ", cooling surface " + short_text(modulus->cooling_area) +
                    after_number(power_of(input.unit, "^2")));
}

void add_section(const Input& input, const Section& section, const Modulus* modulus, std::size_t place,
                 TextReport& text) {
  text.line(std::to_string(place + 1),
            thickness_text(section.ball, input.unit) + ", at " + short_text(section.ball.centre));
  text.line("", "volume " + bounded_text(section.volume, section.volume_error, power_of(input.unit, "^3")) +
                    ", surface " +
                    bounded_text(section.area, section.area_error, power_of(input.unit, "^2")));
  text.line("", "box " + short_text(section.box.lo) + " to " + short_text(section.box.hi) +
                    after_number(input.unit) + ", " + count_text(section.triangles.size()) +
                    " triangles around it, ball touches " + count_text(section.ball.touches.size()));
  add_modulus(input, modulus, text);
}

void add_doubts(const Input& input, const Sections& sections, TextReport& text) {
  for (const MayJoin& join : sections.may_join) {
    text.line("may be one", "sections " + std::to_string(join.first + 1) + " and " +
                                std::to_string(join.second + 1) + ", at " + short_text(join.place) +
                                after_number(input.unit));
  }
  if (!sections.undecided.empty()) {
    text.line("undecided", count_text(sections.undecided.size()) +
                               " places where a tiny section may be, first " +
                               short_text(sections.undecided[0]) + after_number(input.unit));
  }
}

void add_changes(const SectionsRequest& request, const Input& input, const SectionsFinding& finding,
                 TextReport& text) {
  if (!finding.former) return;
  text.line("against", terminal_text(request.against));
  for (const SectionChange& change : finding.changes) {
    std::string line = word_of(change.fate);
    if (change.now && change.former) {
      const Section& now = finding.sections.sections[*change.now];
      const Section& former = finding.former->sections[*change.former];
      const std::string cubic = power_of(input.unit, "^3");
      line += ": was " + thickness_text(former.ball, input.unit) + ", volume " +
              bounded_text(former.volume, former.volume_error, cubic) + ", now " +
              bounded_text(now.volume, now.volume_error, cubic);
    } else if (change.former) {
      const Section& former = finding.former->sections[*change.former];
      line += ": was " + thickness_text(former.ball, input.unit) + ", at " + short_text(former.ball.centre);
    }
    text.line(change.now ? "  " + std::to_string(*change.now + 1) : "  -", line);
  }
}

void add_solid(const SectionsRequest& request, const Input& input, TextReport& text) {
  const MeshReport& mesh = input.field.report();
  add_mesh(mesh, text);
  if (!mesh.embedded()) return;
  text.line("part", "volume " + short_text(mesh.volume) + after_number(power_of(input.unit, "^3")) +
                        ", surface " + short_text(mesh.area) + after_number(power_of(input.unit, "^2")));
  if (request.density > 0) text.line("mass", short_text(mesh.volume * request.density));
}

}  // namespace

Json ball_json(const InscribedBall& ball) {
  return {{"center", json_of(ball.centre)},
          {"radius", ball.radius},
          {"diameter", 2 * ball.radius},
          {"error", ball.error},
          {"touches", ball.touches}};
}

std::string thickness_text(const InscribedBall& ball, const std::string& unit) {
  return bounded_text(2 * ball.radius, 2 * ball.error, unit) + ", depth " +
         bounded_text(ball.radius, ball.error, unit);
}

Json sections_json(const SectionsRequest& request, const Input& input, const SectionsFinding& finding) {
  const Sections& sections = finding.sections;
  Json json = begin_field_report(request.input, input);
  json["depth"] = sections.depth;
  json["thicker_than"] = 2 * sections.depth;
  json["error"] = sections.error;
  json["min_volume"] = request.options.min_volume;
  json["min_depth"] = request.options.min_depth;
  json["sections"] = Json::array();
  for (std::size_t i = 0; i < sections.sections.size(); ++i)
    json["sections"].push_back(section_json(sections.sections[i], modulus_at(finding, i), i));
  json["not_cooling"] = request.modulus ? Json(request.not_cooling) : Json(nullptr);
  json["left_out"] = sections.left_out;
  json["may_join"] = joins_json(sections);
  json["undecided"] = Json::array();
  for (const Vec3& place : sections.undecided) json["undecided"].push_back(json_of(place));
  json["cells"] = sections.cells;
  json["evaluations"] = sections.evaluations;
  add_part(request, input.field.report(), json);
  json["against"] = changes_json(request, finding);
  json["provenance"] = json_of(finding.provenance);
  json["seconds"] = finding.seconds;
  json["field_seconds"] = input.seconds;
  json["output"] = request.output.empty() ? Json(nullptr) : Json(request.output);
  return json;
}

std::string sections_text(const SectionsRequest& request, const Input& input,
                          const SectionsFinding& finding) {
  const Sections& sections = finding.sections;
  const std::string unit = after_number(input.unit);
  TextReport text("sections of " + terminal_text(request.input) + " thicker than " +
                  short_text(2 * sections.depth) + unit + " (depth " + short_text(sections.depth) + unit +
                  ")");
  text.line("sections", sections.sections.empty() ? "none: no place inside is deeper"
                                                  : count_text(sections.sections.size()));
  const std::size_t told = std::min(sections_told, sections.sections.size());
  for (std::size_t i = 0; i < told; ++i)
    add_section(input, sections.sections[i], modulus_at(finding, i), i, text);
  if (told < sections.sections.size())
    text.line("", "and " + count_text(sections.sections.size() - told) + " lesser ones (--json has all)");
  if (sections.left_out > 0)
    text.line("left out", count_text(sections.left_out) + " of less volume or depth");
  add_doubts(input, sections, text);
  add_changes(request, input, finding, text);
  text.line("error asked for", short_text(sections.error) + unit);
  add_solid(request, input, text);
  text.line("sha256 of the input", finding.provenance.sha256);
  text.line("time", seconds_text(finding.seconds) + ", field " + seconds_text(input.seconds));
  if (!request.output.empty()) text.line("written to", terminal_text(request.output));
  return text.text();
}

}  // namespace cdfr::command
