/// One mesh under many points: what the field says against what the oracle says.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"
#include "soak/side_oracle.h"

namespace cdfr::soak {

/// Close means within 4 ulp, ulp at the largest coordinate of mesh and point: what distances are good to.
enum class Verdict : std::uint8_t {
  right,
  right_on_surface,  ///< distance 0 on the surface
  too_close,         ///< distance 0 off the surface, but close to it
  close_side,        ///< wrong sign, close to the surface
  close_on_surface,  ///< not 0 on the surface, but close to it
  wrong_side,        ///< wrong sign, or 0, farther away
  wrong_on_surface,  ///< neither 0 nor close to it on the surface
  not_a_solid,       ///< winding number neither 0 nor 1: the mesh should not have been taken
};
const char* text_of(Verdict verdict) noexcept;
inline bool is_wrong(Verdict verdict) noexcept { return verdict >= Verdict::wrong_side; }
inline bool is_close(Verdict verdict) noexcept {
  return verdict == Verdict::close_side || verdict == Verdict::close_on_surface;
}

struct Finding {
  Verdict verdict = Verdict::right;
  Vec3 point;
  double distance = 0;
};

/// `largest` is the mesh's largest absolute coordinate.
Finding judge(const Field& field, const SideOracle& oracle, double largest, Vec3 point);

struct Outcome {
  std::uint64_t points = 0, on_surface = 0, too_close = 0, close = 0, wrong = 0;
  std::uint64_t asked_twice = 0;  ///< points that the second oracle was asked for too
  std::uint64_t oracles_disagree = 0;
  std::vector<Finding> first_wrong, first_close;  ///< a few, in the order of the points
  std::vector<Vec3> first_disagreed;

  void add_counts(const Outcome& part) noexcept;
};

struct TrialOptions {
  std::uint64_t points = 0, seed = 0;
  unsigned threads = 1;
  std::uint64_t second_opinion = 16;  ///< one point in so many goes to the second oracle too; 0: none
};

/// Points come in chunks, each with a seed of its own, and outcomes are joined in the order of the chunks:
/// the result does not depend on threads. `mesh` as welded() leaves it; `progress` hears the number of points
/// done, from one thread at a time.
Outcome run_trial(const Mesh& mesh, const Field& field, const SideOracle& oracle, const TrialOptions& options,
                  const std::function<void(std::uint64_t)>& progress);

}  // namespace cdfr::soak
