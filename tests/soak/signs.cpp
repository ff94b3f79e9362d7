/// The soak of signs: is any sign wrong, at any point of any mesh that is closed, embedded and outward?
#include <chrono>
#include <cstdio>
#include <string>

#include "cdfr/export/write.h"
#include "cdfr/field/field.h"
#include "soak/catalogue.h"
#include "soak/fitness.h"
#include "soak/options.h"
#include "soak/report.h"
#include "soak/side_oracle.h"
#include "soak/trial.h"
#include "soak/welded.h"

namespace cdfr::soak {
namespace {

Result<Field> build(const Mesh& mesh, unsigned threads) {
  Run run;
  run.threads = threads;
  return Field::build(mesh.view(), {}, run);
}

/// Points under one fit mesh.
void try_field(const Candidate& candidate, const SideOracle& oracle, std::uint64_t points,
               const Options& options, Report& report) {
  const Result<Field> field = build(candidate.mesh, options.threads);
  if (!field) return report.refused(candidate.name, field.error().text);
  if (field->sign() == Sign::none) return report.refused(candidate.name, "the field has no signs");
  const TrialOptions trial{points, candidate.seed, options.threads, options.second_opinion};
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = run_trial(candidate.clean, *field, oracle, trial, [&](std::uint64_t done) {
    report.progress(candidate.name, done, points);
  });
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report.tried(candidate, outcome, seconds.count());
}

/// True if the mesh counts: it was fit.
bool try_mesh(const std::string& name, const Catalogue& catalogue, std::uint64_t points,
              const Options& options, Report& report) {
  std::string why;
  const std::optional<Candidate> candidate = catalogue.make(name, why);
  if (candidate) {
    const SideOracle oracle(candidate->clean);
    why = why_unfit(candidate->clean, oracle);
    if (why.empty()) return try_field(*candidate, oracle, points, options, report), true;
  }
  report.skipped(name, why);
  return false;
}

int soak(const Options& options) {
  const Catalogue catalogue(options.seed);
  Report report(options);
  report.heading();
  // Where --only leaves few, the search for more ends somewhere.
  const std::uint64_t last = 2 * catalogue.model_count() + 100 * options.meshes;
  std::uint64_t taken = 0;
  for (std::uint64_t place = 0; place < last && taken < options.meshes; ++place) {
    const std::string name = catalogue.name(place);
    if (name.find(options.only) == std::string::npos) continue;
    const std::uint64_t points =
        options.points / options.meshes + (taken < options.points % options.meshes ? 1 : 0);
    if (try_mesh(name, catalogue, points, options, report)) ++taken;
  }
  return report.summary();
}

int replay_point(const Candidate& candidate, const Field& field, const SideOracle& oracle, const Vec3& p) {
  const Finding finding = judge(field, oracle, largest_coordinate(candidate.clean), p);
  const Closest closest = field.closest(p);
  static constexpr const char* features[] = {"face", "edge", "vertex"};
  std::printf("point %a %a %a = (%.17g, %.17g, %.17g)\n", p.x, p.y, p.z, p.x, p.y, p.z);
  std::printf("distance %.17g: %s\n", finding.distance, text_of(finding.verdict));
  std::printf("closest: triangle %u, %s %d, (%.17g, %.17g, %.17g)\n", closest.triangle,
              features[static_cast<int>(closest.feature)], closest.element, closest.point.x, closest.point.y,
              closest.point.z);
  const std::optional<int> winding = oracle.winding(p);
  std::printf("oracle: %s\n", !winding ? "on the surface" : (*winding == 0 ? "outside" : "inside"));
  return is_wrong(finding.verdict) || is_close(finding.verdict) ? 1 : 0;
}

int replay(const Options& options) {
  std::string why;
  const std::optional<Candidate> candidate = Catalogue(options.seed).make(options.replay, why);
  if (!candidate) {
    std::fprintf(stderr, "signs: %s: %s\n", options.replay.c_str(), why.c_str());
    return 2;
  }
  const SideOracle oracle(candidate->clean);
  const std::string unfit = why_unfit(candidate->clean, oracle);
  std::printf("%s: %s, %zu triangles, %s\n", candidate->name.c_str(), candidate->text.c_str(),
              candidate->mesh.triangles.size(), unfit.empty() ? "fit" : unfit.c_str());
  if (!options.write.empty()) {
    if (const Result<void> written = write_mesh(candidate->mesh.view(), options.write); !written) {
      std::fprintf(stderr, "signs: %s: %s\n", options.write.c_str(), written.error().text.c_str());
      return 2;
    }
  }
  if (!options.point) return 0;
  const Result<Field> field = build(candidate->mesh, options.threads);
  if (!field) {
    std::fprintf(stderr, "signs: %s: %s\n", options.replay.c_str(), field.error().text.c_str());
    return 1;
  }
  return replay_point(*candidate, *field, oracle, *options.point);
}

}  // namespace
}  // namespace cdfr::soak

int main(int argc, char** argv) {
  const cdfr::soak::Parsed parsed = cdfr::soak::parse(argc, argv);
  if (parsed.exit_status) return *parsed.exit_status;
  return parsed.options.replay.empty() ? cdfr::soak::soak(parsed.options)
                                       : cdfr::soak::replay(parsed.options);
}
