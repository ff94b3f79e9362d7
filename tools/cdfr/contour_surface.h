/// contour --mesh: the contour as a triangle mesh, in a file.
#pragma once

#include <string>

#include "input.h"
#include "settings.h"

namespace cdfr::command {

struct SurfaceRequest {
  std::string input, output;
  double distance = 0, tolerance = 0;  ///< tolerance 0: longest side / 1000
  std::string title;                   ///< of the report for people
  const Settings& settings;
};

/// Refuses what would fail after the work.
void check_surface_target(const std::string& output);

/// Extracts, writes and reports.
void contour_surface(const SurfaceRequest& request, const Input& input);

}  // namespace cdfr::command
