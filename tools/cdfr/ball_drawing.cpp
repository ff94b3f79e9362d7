#include "ball_drawing.h"

#include <algorithm>
#include <limits>

#include "cdfr/export/painted.h"
#include "number_text.h"
#include "output_target.h"
#include "stop.h"
#include "unit.h"

namespace cdfr::command {
namespace {

constexpr std::size_t most_balls = 1000, most_labels = 20;

/// By triangle, NaN where there is none.
struct Painting {
  std::vector<double> rank, diameter;
};

Painting painting_of(std::span<const DrawnBall> balls, std::size_t triangles) {
  Painting painting;
  painting.rank.assign(triangles, std::numeric_limits<double>::quiet_NaN());
  painting.diameter = painting.rank;
  for (std::size_t i = balls.size(); i-- > 0;) {
    for (const std::uint32_t triangle : balls[i].triangles) {
      painting.rank[triangle] = static_cast<double>(i + 1);
      painting.diameter[triangle] = 2 * balls[i].ball->radius;
    }
  }
  return painting;
}

}  // namespace

bool is_drawn(const std::string& output) {
  const std::string extension = extension_of(output);
  return extension == ".glb" || extension == ".ply" || extension == ".vtp";
}

void draw_balls(const Mesh& part, std::span<const DrawnBall> balls, double least, const std::string& unit,
                const Provenance& provenance, const std::string& output) {
  const Painting painting = painting_of(balls, part.triangles.size());
  PaintedMesh painted;
  painted.mesh = part.view();
  painted.arrays = {{"diameter", ArrayPlace::face, painting.diameter},
                    {"section", ArrayPlace::face, painting.rank}};
  painted.painted = "diameter";
  painted.least = least;
  painted.greatest = balls.empty() ? least : 2 * balls[0].ball->radius;
  painted.unit = unit;
  painted.translucent = true;
  for (std::size_t i = 0; i < std::min(most_balls, balls.size()); ++i) {
    const InscribedBall& ball = *balls[i].ball;
    painted.balls.push_back({ball.centre, ball.radius});
    if (i < most_labels) {
      painted.labels.push_back(
          {ball.centre, std::to_string(i + 1) + ": " + bounded_text(2 * ball.radius, 2 * ball.error, unit)});
    }
  }
  painted.notes = lines_of(provenance);
  const double metres = extension_of(output) == ".glb" ? metres_in(unit).value_or(1) : 1;
  need(write_painted(painted, output, metres), output);
}

}  // namespace cdfr::command
