#include "sections_output.h"

#include <vector>

#include "ball_drawing.h"
#include "byte_sink.h"
#include "number_text.h"
#include "output_target.h"
#include "sections_report.h"
#include "stop.h"

namespace cdfr::command {
namespace {

void append_row(std::string& text, const Section& section, const Modulus* modulus, std::size_t rank) {
  text += std::to_string(rank);
  const InscribedBall& ball = section.ball;
  for (const double value :
       {ball.centre.x, ball.centre.y, ball.centre.z, ball.radius, 2 * ball.radius, ball.error, section.volume,
        section.volume_error, section.area, section.area_error, section.box.lo.x, section.box.lo.y,
        section.box.lo.z, section.box.hi.x, section.box.hi.y, section.box.hi.z}) {
    text += ',';
    append_exact(text, value);
  }
  text += "," + std::to_string(section.triangles.size()) + "," + std::to_string(section.cells);
  for (const double Modulus::*number : {&Modulus::value, &Modulus::error}) {
    text += ',';
    if (modulus != nullptr) append_exact(text, modulus->*number);
  }
  text += '\n';
}

std::string csv_of(const SectionsFinding& finding) {
  const std::vector<Section>& sections = finding.sections.sections;
  std::string text =
      "rank,x,y,z,radius,diameter,error,volume,volume_error,area,area_error,x_min,y_min,z_min,x_max,y_max,z_"
      "max,"
      "triangles,cells,modulus,modulus_error\n";
  for (std::size_t i = 0; i < sections.size(); ++i)
    append_row(text, sections[i], finding.moduli.empty() ? nullptr : &finding.moduli[i], i + 1);
  return text;
}

void draw(const SectionsRequest& request, const Input& input, const Mesh& part,
          const SectionsFinding& finding) {
  std::vector<DrawnBall> balls;
  for (const Section& section : finding.sections.sections)
    balls.push_back({&section.ball, section.triangles});
  draw_balls(part, balls, 2 * finding.sections.depth, input.unit, finding.provenance, request.output);
}

}  // namespace

void check_sections_target(const SectionsRequest& request) {
  if (!request.part.empty() && !is_drawn(request.output))
    stop_usage("--part is for -o FILE.glb, FILE.ply or FILE.vtp");
  if (!request.output.empty()) check_target(request.output, {".json", ".csv", ".glb", ".ply", ".vtp"});
}

void write_sections(const SectionsRequest& request, const Input& input, const Mesh& part,
                    const SectionsFinding& finding) {
  if (request.output.empty()) return;
  if (is_drawn(request.output)) return draw(request, input, part, finding);
  const auto sink = whole_file(request.output);
  sink->write(extension_of(request.output) == ".csv" ? csv_of(finding)
                                                     : text_of(sections_json(request, input, finding)));
  stop_if_interrupted();
  sink->finish();
}

}  // namespace cdfr::command
