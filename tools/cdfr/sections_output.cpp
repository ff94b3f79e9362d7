#include "sections_output.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "byte_sink.h"
#include "cdfr/export/painted.h"
#include "number_text.h"
#include "output_target.h"
#include "sections_report.h"
#include "stop.h"
#include "unit.h"

namespace cdfr::command {
namespace {

constexpr std::size_t most_balls = 1000, most_labels = 20;

void append_row(std::string& text, const Section& section, std::size_t rank) {
  text += std::to_string(rank);
  const InscribedBall& ball = section.ball;
  for (const double value :
       {ball.centre.x, ball.centre.y, ball.centre.z, ball.radius, 2 * ball.radius, ball.error, section.volume,
        section.volume_error, section.area, section.area_error, section.box.lo.x, section.box.lo.y,
        section.box.lo.z, section.box.hi.x, section.box.hi.y, section.box.hi.z}) {
    text += ',';
    append_exact(text, value);
  }
  text += "," + std::to_string(section.triangles.size()) + "," + std::to_string(section.cells) + "\n";
}

std::string csv_of(const Sections& sections) {
  std::string text =
      "rank,x,y,z,radius,diameter,error,volume,volume_error,area,area_error,x_min,y_min,z_min,x_max,y_max,z_"
      "max,"
      "triangles,cells\n";
  for (std::size_t i = 0; i < sections.sections.size(); ++i) append_row(text, sections.sections[i], i + 1);
  return text;
}

/// By triangle: of the section that it bounds, the one with the larger ball if there are two.
struct Painting {
  std::vector<double> section, diameter;
};

Painting painting_of(const Sections& sections, std::size_t triangles) {
  Painting painting;
  painting.section.assign(triangles, std::numeric_limits<double>::quiet_NaN());
  painting.diameter = painting.section;
  for (std::size_t i = sections.sections.size(); i-- > 0;) {
    for (const std::uint32_t triangle : sections.sections[i].triangles) {
      painting.section[triangle] = static_cast<double>(i + 1);
      painting.diameter[triangle] = 2 * sections.sections[i].ball.radius;
    }
  }
  return painting;
}

void draw(const SectionsRequest& request, const Input& input, const Mesh& part,
          const SectionsFinding& finding) {
  const Sections& sections = finding.sections;
  const Painting painting = painting_of(sections, part.triangles.size());
  PaintedMesh painted;
  painted.mesh = part.view();
  painted.arrays = {{"diameter", ArrayPlace::face, painting.diameter},
                    {"section", ArrayPlace::face, painting.section}};
  painted.painted = "diameter";
  painted.least = 2 * sections.depth;
  painted.greatest = sections.sections.empty() ? painted.least : 2 * sections.sections[0].ball.radius;
  painted.unit = input.unit;
  painted.translucent = true;
  for (std::size_t i = 0; i < std::min(most_balls, sections.sections.size()); ++i) {
    const InscribedBall& ball = sections.sections[i].ball;
    painted.balls.push_back({ball.centre, ball.radius});
    if (i < most_labels) {
      painted.labels.push_back({ball.centre, std::to_string(i + 1) + ": " +
                                                 bounded_text(2 * ball.radius, 2 * ball.error, input.unit)});
    }
  }
  painted.notes = lines_of(finding.provenance);
  const bool in_metres = extension_of(request.output) == ".glb";
  need(write_painted(painted, request.output, in_metres ? metres_in(input.unit).value_or(1) : 1),
       request.output);
}

}  // namespace

void check_sections_target(const SectionsRequest& request) {
  if (!request.part.empty() && !is_drawn(request))
    stop_usage("--part is for -o FILE.glb, FILE.ply or FILE.vtp");
  if (!request.output.empty()) check_target(request.output, {".json", ".csv", ".glb", ".ply", ".vtp"});
}

bool is_drawn(const SectionsRequest& request) {
  const std::string extension = extension_of(request.output);
  return extension == ".glb" || extension == ".ply" || extension == ".vtp";
}

void write_sections(const SectionsRequest& request, const Input& input, const Mesh& part,
                    const SectionsFinding& finding) {
  if (request.output.empty()) return;
  if (is_drawn(request)) return draw(request, input, part, finding);
  const auto sink = whole_file(request.output);
  sink->write(extension_of(request.output) == ".csv" ? csv_of(finding.sections)
                                                     : text_of(sections_json(request, input, finding)));
  stop_if_interrupted();
  sink->finish();
}

}  // namespace cdfr::command
