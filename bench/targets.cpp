#include "targets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "system.h"

namespace cdfr::bench {
namespace {

/// One value for each model that has one.
template <class Value>
Rounds over_models(const std::vector<Sheet>& sheets, Value value) {
  Rounds values;
  for (const Sheet& sheet : sheets) {
    const double v = value(sheet);
    if (!std::isnan(v)) values.push_back(v);
  }
  return values;
}

Rounds ratios(const std::vector<Sheet>& sheets, const char* peer, const char* workload) {
  return over_models(sheets, [&](const Sheet& s) { return median(s.ratios(peer, workload)); });
}

double least(const Rounds& values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : *std::min_element(values.begin(), values.end());
}

double most(const Rounds& values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : *std::max_element(values.begin(), values.end());
}

double time_of(const Sheet& sheet, const char* system, const char* workload) {
  const Rounds* rounds = sheet.find(system, workload);
  return rounds == nullptr ? std::numeric_limits<double>::quiet_NaN() : median(*rounds);
}

double misses(const Sheet& sheet) {
  return time_of(sheet, "cdfr", "random") / time_of(sheet, "machine", "miss");
}

/// NaN for models that are too small or too large to count. A scan of "a million" has a few more.
double build_microseconds(const Sheet& sheet) {
  const double triangles = sheet.fact("cdfr", "triangles");
  if (triangles < 50'000 || triangles > 1'100'000) return std::numeric_limits<double>::quiet_NaN();
  return time_of(sheet, "cdfr", "build") / 1000 / triangles;
}

double share_of_memory_allowed(const Sheet& sheet) {
  return sheet.fact("cdfr", "bytes") / (400 * sheet.fact("cdfr", "triangles") + 256 * 1024);
}

/// cdfr's time as a share of the least that a peer takes. NaN without peers.
template <class Time>
double share_of_best_peer(Time time) {
  double best = std::numeric_limits<double>::infinity();
  for (const SystemKind& peer : peer_kinds()) best = std::fmin(best, time(peer.name));
  return time("cdfr") / best;
}

double share_of_total(const Sheet& sheet, std::size_t queries) {
  const std::string workload = "total" + std::to_string(queries);
  return share_of_best_peer([&](const char* system) { return time_of(sheet, system, workload.c_str()); });
}

/// So many that they are not asked: from the time of one. cdfr is not told how many there will be.
double share_of_many(const Sheet& sheet, double queries) {
  return share_of_best_peer([&](const char* system) {
    return time_of(sheet, system, "build") + queries * time_of(sheet, system, "random");
  });
}

double gain_of_two_threads(const Sheet& sheet, const std::string& workload) {
  return time_of(sheet, "cdfr", workload.c_str()) / time_of(sheet, "cdfr", (workload + "2").c_str());
}

}  // namespace

std::vector<Target> targets(const std::vector<Sheet>& sheets) {
  std::vector<Target> list{
      {"random, times as fast as embree", true, 8, median(ratios(sheets, "embree", "random"))},
      {"random, times as fast as cgal", true, 30, median(ratios(sheets, "cgal", "random"))},
      {"random, in dependent misses", false, 3.5, median(over_models(sheets, misses))},
      {"near, times as fast as embree", true, 3, median(ratios(sheets, "embree", "near"))},
      {"far, times as fast as embree", true, 1, median(ratios(sheets, "embree", "far"))},
      {"batch, times as fast as embree's single queries", true, 20,
       median(ratios(sheets, "embree", "batch"))},
      {"grid, times as fast as embree", true, 60, median(ratios(sheets, "embree", "grid"))},
      {"worst model, random, times as fast as embree", true, 2.5, least(ratios(sheets, "embree", "random"))},
      {"worst model, near, times as fast as embree", true, 1, least(ratios(sheets, "embree", "near"))},
      {"build, us a triangle, 50,000 triangles and more", false, 25,
       median(over_models(sheets, build_microseconds))},
      {"worst model, share of 400 bytes a triangle + 256 KiB", false, 1,
       most(over_models(sheets, share_of_memory_allowed))},
  };
  for (const std::size_t queries : total_queries) {
    list.push_back({"build and " + std::to_string(queries) + " queries, times as long as the best peer",
                    false, 1.5,
                    median(over_models(sheets, [&](const Sheet& s) { return share_of_total(s, queries); }))});
  }
  list.push_back({"build and 1000000 queries, times as long as the best peer", false, 1,
                  median(over_models(sheets, [](const Sheet& s) { return share_of_many(s, 1e6); }))});
  for (const char* workload : {"build", "batch", "grid"}) {
    const auto gain = [&](const Sheet& s) { return gain_of_two_threads(s, workload); };
    list.push_back({std::string(workload) + ", times as fast with 2 threads", true, 1.8,
                    median(over_models(sheets, gain))});
  }
  return list;
}

}  // namespace cdfr::bench
