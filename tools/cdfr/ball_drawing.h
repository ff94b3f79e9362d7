/// A part with balls in it, as a file to look at.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cdfr/analysis/ball.h"
#include "cdfr/mesh/mesh.h"
#include "input.h"
#include "provenance.h"

namespace cdfr::command {

/// What is drawn of a section or a hot spot.
struct DrawnBall {
  const InscribedBall* ball;
  std::span<const std::uint32_t> triangles;  ///< of the part, coloured by the ball's diameter
};

/// Does a file of that name show the part's triangles?
bool is_drawn(const std::string& output);

/// .glb, .ply or .vtp: the part translucent, with the balls and their labels. Triangles of several balls have
/// the colour of the first. `least` is the diameter of the first colour, that of the first ball the last.
void draw_balls(const Mesh& part, std::span<const DrawnBall> balls, double least, const std::string& unit,
                const Provenance& provenance, const std::string& output);

}  // namespace cdfr::command
