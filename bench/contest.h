/// Every system made ready over the mesh of one course, and the truth to hold their answers against.
#pragma once

#include <memory>
#include <vector>

#include "cdfr/core/result.h"
#include "course.h"
#include "system.h"

namespace cdfr::bench {

/// What brute force says.
struct Truth {
  std::vector<Vec3> points;  ///< of all kinds: every one, or as many as brute force has time for
  std::vector<double> distances;
};

struct Contest {
  Course course;
  Truth truth;
  std::vector<std::unique_ptr<System>> systems;  ///< as system_kinds()
};

Result<Contest> make_contest(const Model& model, const Effort& effort);

}  // namespace cdfr::bench
