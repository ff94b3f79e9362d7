/// A mesh with its field and its brute force, and what every point of a contour must be.
#pragma once

#include <cstddef>
#include <vector>

#include "cdfr/contour/contour.h"
#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

struct Case {
  explicit Case(Mesh made, const BuildOptions& options = {});

  Mesh mesh;
  Field field;
  BruteForce brute;
};

struct Contour {
  double distance = 0;
  double tolerance = 0;
  std::vector<ContourPoint> points;
  ContourReport report;
};

/// Extracts with a sink and checks that the report fits the points.
Contour contour_of(const Field& field, double distance, double tolerance);

/// Fails if the true contour does not pass within the error of every `stride`-th point, or its normal or
/// triangle is wrong.
void expect_true_points(const Case& part, const Contour& contour, std::size_t stride = 1);

/// Where the triangular prism with a ridge of two degrees along y lies: its tip at the origin, `length` along
/// x and y.
inline constexpr double wedge_length = 3;
Mesh wedge_mesh();
/// Sine of one degree, half the wedge's angle.
double half_angle_sine();

}  // namespace cdfr::test
