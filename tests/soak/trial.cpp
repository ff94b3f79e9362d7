#include "soak/trial.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <thread>

#include "soak/point_source.h"
#include "soak/second_oracle.h"
#include "soak/welded.h"

namespace cdfr::soak {
namespace {

constexpr std::uint64_t chunk_size = 2048;
constexpr std::size_t most_findings = 4;

double ulp_at(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()) - x; }

double largest_with(double largest, const Vec3& p) {
  return std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

template <class T>
void append(std::vector<T>& few, const T& item) {
  if (few.size() < most_findings) few.push_back(item);
}

class Trial {
 public:
  Trial(const Mesh& mesh, const Field& field, const SideOracle& oracle, const TrialOptions& options)
      : field_(field),
        oracle_(oracle),
        second_(mesh),
        source_(mesh, field),
        largest_(largest_coordinate(mesh)),
        options_(options) {}

  Outcome chunk(std::uint64_t number) const {
    Outcome outcome;
    test::Random random(test::Random(options_.seed + number * 0x9e3779b97f4a7c15U).bits());
    outcome.points = std::min(chunk_size, options_.points - number * chunk_size);
    for (std::uint64_t i = 0; i < outcome.points; ++i) {
      const Vec3 p = source_.draw(random);
      count(judge(field_, oracle_, largest_, p), outcome);
      if (options_.second_opinion > 0 && i % options_.second_opinion == 0) ask_again(p, outcome);
    }
    return outcome;
  }

 private:
  static void count(const Finding& finding, Outcome& outcome) {
    const Verdict v = finding.verdict;
    outcome.on_surface +=
        v == Verdict::right_on_surface || v == Verdict::wrong_on_surface || v == Verdict::close_on_surface;
    outcome.too_close += v == Verdict::too_close;
    outcome.close += is_close(v);
    outcome.wrong += is_wrong(v);
    if (is_close(v)) append(outcome.first_close, finding);
    if (is_wrong(v)) append(outcome.first_wrong, finding);
  }

  void ask_again(const Vec3& p, Outcome& outcome) const {
    const std::optional<int> other = second_.side(p);
    if (!other) return;
    const std::optional<int> winding = oracle_.winding(p);
    const int side = winding ? (*winding != 0 ? -1 : 1) : 0;
    ++outcome.asked_twice;
    if (side == *other) return;
    ++outcome.oracles_disagree;
    append(outcome.first_disagreed, p);
  }

  const Field& field_;
  const SideOracle& oracle_;
  SecondOracle second_;
  PointSource source_;
  double largest_;
  TrialOptions options_;
};

void join(Outcome& all, const Outcome& part) {
  all.add_counts(part);
  for (const Finding& finding : part.first_wrong) append(all.first_wrong, finding);
  for (const Finding& finding : part.first_close) append(all.first_close, finding);
  for (const Vec3& p : part.first_disagreed) append(all.first_disagreed, p);
}

}  // namespace

const char* text_of(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::right:
      return "right";
    case Verdict::right_on_surface:
      return "right, on the surface";
    case Verdict::too_close:
      return "0, too close to have a side";
    case Verdict::close_side:
      return "wrong side within 4 ulp";
    case Verdict::close_on_surface:
      return "on the surface, and not 0 but within 4 ulp";
    case Verdict::wrong_side:
      return "WRONG SIDE";
    case Verdict::wrong_on_surface:
      return "ON THE SURFACE, and not 0";
    case Verdict::not_a_solid:
      return "winding number neither 0 nor 1";
  }
  return "";
}

void Outcome::add_counts(const Outcome& part) noexcept {
  points += part.points;
  on_surface += part.on_surface;
  too_close += part.too_close;
  close += part.close;
  wrong += part.wrong;
  asked_twice += part.asked_twice;
  oracles_disagree += part.oracles_disagree;
}

Finding judge(const Field& field, const SideOracle& oracle, double largest, Vec3 point) {
  const double d = field.distance(point);
  const double close = 4 * ulp_at(largest_with(largest, point));
  const std::optional<int> winding = oracle.winding(point);
  const auto verdict = [&] {
    if (!winding) {
      if (d == 0) return Verdict::right_on_surface;
      return std::fabs(d) <= close ? Verdict::close_on_surface : Verdict::wrong_on_surface;
    }
    if (*winding != 0 && *winding != 1) return Verdict::not_a_solid;
    if (*winding == 1 ? d < 0 : d > 0) return Verdict::right;
    if (std::isnan(d) || !oracle.within(point, close)) return Verdict::wrong_side;
    return d == 0 ? Verdict::too_close : Verdict::close_side;
  };
  return {verdict(), point, d};
}

Outcome run_trial(const Mesh& mesh, const Field& field, const SideOracle& oracle, const TrialOptions& options,
                  const std::function<void(std::uint64_t)>& progress) {
  const Trial trial(mesh, field, oracle, options);
  const std::uint64_t chunks = (options.points + chunk_size - 1) / chunk_size;
  std::vector<Outcome> outcomes(chunks);
  std::atomic<std::uint64_t> next = 0;
  std::mutex mutex;
  std::uint64_t done = 0;
  const auto work = [&] {
    for (std::uint64_t i = next++; i < chunks; i = next++) {
      outcomes[i] = trial.chunk(i);
      const std::scoped_lock lock(mutex);
      progress(done += outcomes[i].points);
    }
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 1; i < options.threads; ++i) workers.emplace_back(work);
  work();
  workers.clear();
  Outcome all;
  for (const Outcome& outcome : outcomes) join(all, outcome);
  return all;
}

}  // namespace cdfr::soak
