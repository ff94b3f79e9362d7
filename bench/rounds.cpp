#include "rounds.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace cdfr::bench {
namespace {

/// Between the two nearest values; `sorted` is not empty.
double quantile(const Rounds& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

}  // namespace

double median(Rounds values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return quantile(values, 0.5);
}

double spread(Rounds values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return (quantile(values, 0.75) - quantile(values, 0.25)) / quantile(values, 0.5);
}

const Rounds* Sheet::find(const std::string& system, const std::string& workload) const {
  const auto workloads = times.find(system);
  if (workloads == times.end()) return nullptr;
  const auto found = workloads->second.find(workload);
  return found == workloads->second.end() ? nullptr : &found->second;
}

double Sheet::fact(const std::string& system, const std::string& name) const {
  const auto names = facts.find(system);
  if (names == facts.end() || !names->second.contains(name)) return std::numeric_limits<double>::quiet_NaN();
  return names->second.at(name);
}

Rounds Sheet::ratios(const std::string& system, const std::string& workload) const {
  const Rounds* theirs = find(system, workload);
  const Rounds* ours = find("cdfr", workload);
  Rounds ratios;
  if (theirs == nullptr || ours == nullptr) return ratios;
  for (std::size_t i = 0; i < std::min(theirs->size(), ours->size()); ++i) {
    ratios.push_back((*theirs)[i] / (*ours)[i]);
  }
  return ratios;
}

Sheet& RoundsReporter::sheet(const std::string& model) {
  const auto found =
      std::find_if(sheets_.begin(), sheets_.end(), [&](const Sheet& s) { return s.model == model; });
  if (found != sheets_.end()) return *found;
  sheets_.push_back({model, {}, {}});
  return sheets_.back();
}

void RoundsReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    const std::string& name = run.run_name.function_name;
    if (run.error_occurred) {
      failed_ = true;
      std::fprintf(stderr, "%s: %s\n", name.c_str(), run.error_message.c_str());
      continue;
    }
    const std::size_t first = name.find('/'), second = name.find('/', first + 1);
    const std::string workload = name.substr(0, first), system = name.substr(first + 1, second - first - 1);
    Sheet& target = sheet(name.substr(second + 1));
    const auto items = run.counters.find("items");
    if (items == run.counters.end()) {
      for (const auto& [fact, value] : run.counters) target.facts[system][fact] = value.value;
      continue;
    }
    const double each = run.GetAdjustedRealTime() / items->second.value;
    target.times[system][workload].push_back(each);
    std::fprintf(stderr, "%-50s %12.1f ns each, %.0f of them\n", name.c_str(), each, items->second.value);
  }
}

}  // namespace cdfr::bench
