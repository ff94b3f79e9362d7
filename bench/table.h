/// Collects what Google Benchmark measured into one row a model, printed as columns and written as JSON.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cdfr::bench {

/// A benchmark is named "measure/model"; each of its counters becomes the value of that name in the model's
/// row. Counters named as a column appear in the table, all of them in the JSON.
class TableReporter : public benchmark::BenchmarkReporter {
 public:
  explicit TableReporter(std::vector<std::string> columns) : columns_(std::move(columns)) {}

  bool ReportContext(const Context&) override { return true; }
  /// Says on stderr how far it is.
  void ReportRuns(const std::vector<Run>& runs) override;
  void print() const;
  /// False if the file cannot be written.
  bool write_json(const std::string& path) const;
  bool failed() const noexcept { return failed_; }
  /// Runs what is registered, prints the table, and writes the JSON too if a path is given. Exit status.
  int run_and_report(const std::string& json);

 private:
  struct Row {
    std::string model;
    std::map<std::string, double> values;
  };
  Row& row(const std::string& model);

  std::vector<std::string> columns_;
  std::vector<Row> rows_;
  bool failed_ = false;
};

}  // namespace cdfr::bench
