/// What repeated measuring gave, and how far to trust it.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace cdfr::bench {

/// One value a round.
using Rounds = std::vector<double>;

double median(Rounds values);
/// Width of the middle half of the values, as a share of their median.
double spread(Rounds values);

/// Of one model.
struct Sheet {
  std::string model;
  std::map<std::string, std::map<std::string, Rounds>> times;  ///< ns by system and workload
  std::map<std::string, std::map<std::string, double>> facts;  ///< by system and name

  const Rounds* find(const std::string& system, const std::string& workload) const;
  double fact(const std::string& system, const std::string& name) const;
  /// How many times as long as cdfr, round by round; empty if one of the two is missing.
  Rounds ratios(const std::string& system, const std::string& workload) const;
};

/// A benchmark is named "workload/system/model". Its time counts as one round, divided by the counter
/// "items"; one without that counter states facts.
class RoundsReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  /// Says on stderr how far it is.
  void ReportRuns(const std::vector<Run>& runs) override;
  const std::vector<Sheet>& sheets() const noexcept { return sheets_; }
  bool failed() const noexcept { return failed_; }

 private:
  Sheet& sheet(const std::string& model);

  std::vector<Sheet> sheets_;
  bool failed_ = false;
};

}  // namespace cdfr::bench
