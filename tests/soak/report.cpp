#include "soak/report.h"

#include <cinttypes>
#include <cstdio>

namespace cdfr::soak {

void Report::heading() const {
  std::printf("%-46s %9s %10s %6s %6s %10s %9s %8s  %s\n", "mesh", "triangles", "points", "wrong", "<4ulp",
              "on surface", "too close", "seconds", "what it is");
}

void Report::skipped(const std::string& name, const std::string& why) {
  ++skipped_;
  std::printf("%-46s skipped: %s\n", name.c_str(), why.c_str());
  std::fflush(stdout);
}

void Report::progress(const std::string& name, std::uint64_t points_of_mesh, std::uint64_t of_mesh) {
  const Clock::time_point now = Clock::now();
  if (now - last_progress_ < std::chrono::seconds(10)) return;
  last_progress_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double all = static_cast<double>(sum_.points + points_of_mesh);
  std::fprintf(stderr,
               "signs: %5.1f %%, mesh %" PRIu64 " of %" PRIu64 ", %s %.0f %%, %.0f s, %.3g points/s\n",
               100 * all / static_cast<double>(options_.points), meshes_ + 1, options_.meshes, name.c_str(),
               of_mesh == 0 ? 0 : 100.0 * static_cast<double>(points_of_mesh) / static_cast<double>(of_mesh),
               seconds, all / seconds);
}

void Report::refused(const std::string& name, const std::string& why) {
  ++refused_;
  ++meshes_;
  std::printf("%-46s REFUSED: %s\n", name.c_str(), why.c_str());
  std::fflush(stdout);
}

void Report::replay_line(const std::string& name, const Vec3& p, const std::string& what) const {
  std::printf("  %s: tools/soak signs --seed %" PRIu64 " --replay %s %a %a %a\n", what.c_str(), options_.seed,
              name.c_str(), p.x, p.y, p.z);
}

void Report::finding_line(const std::string& name, const Finding& finding) const {
  char distance[40];
  std::snprintf(distance, sizeof distance, ", distance %.17g", finding.distance);
  replay_line(name, finding.point, text_of(finding.verdict) + std::string(distance));
}

void Report::tried(const Candidate& candidate, const Outcome& outcome, double seconds) {
  ++meshes_;
  trial_seconds_ += seconds;
  sum_.add_counts(outcome);
  std::printf("%-46s %9zu %10" PRIu64 " %6" PRIu64 " %6" PRIu64 " %10" PRIu64 " %9" PRIu64 " %8.2f  %s\n",
              candidate.name.c_str(), candidate.mesh.triangles.size(), outcome.points, outcome.wrong,
              outcome.close, outcome.on_surface, outcome.too_close, seconds, candidate.text.c_str());
  for (const Finding& finding : outcome.first_wrong) finding_line(candidate.name, finding);
  for (const Finding& finding : outcome.first_close) finding_line(candidate.name, finding);
  for (const Vec3& p : outcome.first_disagreed) replay_line(candidate.name, p, "the oracles disagree");
  std::fflush(stdout);
}

int Report::summary() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  std::printf("signs: %" PRIu64 " points on %" PRIu64 " meshes, %" PRIu64 " wrong, %" PRIu64
              " wrong within 4 ulp, %" PRIu64 " on the surface, %" PRIu64
              " too close to have a side, %" PRIu64 " of %" PRIu64 " second opinions differ, %" PRIu64
              " meshes refused, %" PRIu64 " unfit, seed %" PRIu64 ", %.0f s, %.3g points/s\n",
              sum_.points, meshes_, sum_.wrong, sum_.close, sum_.on_surface, sum_.too_close,
              sum_.oracles_disagree, sum_.asked_twice, refused_, skipped_, options_.seed, seconds,
              trial_seconds_ > 0 ? static_cast<double>(sum_.points) / trial_seconds_ : 0);
  const bool right = sum_.wrong == 0 && (options_.lenient || sum_.close == 0) && sum_.oracles_disagree == 0 &&
                     refused_ == 0 && meshes_ > 0;
  return right ? 0 : 1;
}

}  // namespace cdfr::soak
