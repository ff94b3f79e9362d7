/// What the soak prints: a line a mesh and replayable lines on stdout, progress on stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "soak/catalogue.h"
#include "soak/options.h"
#include "soak/trial.h"

namespace cdfr::soak {

class Report {
 public:
  explicit Report(const Options& options) : options_(options) {}

  void heading() const;
  void skipped(const std::string& name, const std::string& why);
  void progress(const std::string& name, std::uint64_t points_of_mesh, std::uint64_t of_mesh);
  /// Library at fault, beyond single points: no field, or an unsigned one.
  void refused(const std::string& name, const std::string& why);
  void tried(const Candidate& candidate, const Outcome& outcome, double seconds);
  /// The last line; the status to exit with.
  int summary() const;

 private:
  using Clock = std::chrono::steady_clock;
  void finding_line(const std::string& name, const Finding& finding) const;
  void replay_line(const std::string& name, const Vec3& p, const std::string& what) const;

  const Options& options_;
  Clock::time_point start_ = Clock::now(), last_progress_ = start_;
  Outcome sum_;
  double trial_seconds_ = 0;
  std::uint64_t meshes_ = 0, skipped_ = 0, refused_ = 0;
};

}  // namespace cdfr::soak
