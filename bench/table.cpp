#include "table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

namespace cdfr::bench {

TableReporter::Row& TableReporter::row(const std::string& model) {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.model == model; });
  if (found != rows_.end()) return *found;
  rows_.push_back({model, {}});
  return rows_.back();
}

void TableReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    const std::string& name = run.run_name.function_name;
    if (run.error_occurred) {
      failed_ = true;
      std::fprintf(stderr, "%s: %s\n", name.c_str(), run.error_message.c_str());
      continue;
    }
    if (run.run_type != Run::RT_Iteration) continue;
    std::fprintf(stderr, "%-40s %12.3f ms, %lld times\n", name.c_str(), run.GetAdjustedRealTime(),
                 static_cast<long long>(run.iterations));
    const std::string model = name.substr(name.find('/') + 1);
    for (const auto& [counter, value] : run.counters) row(model).values[counter] = value.value;
  }
}

void TableReporter::print() const {
  std::printf("\n%-22s", "model");
  for (const std::string& column : columns_) std::printf("  %8s", column.c_str());
  std::printf("\n");
  for (const Row& row : rows_) {
    std::printf("%-22s", row.model.c_str());
    for (const std::string& column : columns_) {
      const auto found = row.values.find(column);
      const int width = std::max(8, static_cast<int>(column.size()));
      if (found == row.values.end()) {
        std::printf("  %*s", width, "-");
      } else {
        const bool fraction = found->second < 100 && found->second != std::floor(found->second);
        std::printf("  %*.*f", width, fraction ? 2 : 0, found->second);
      }
    }
    std::printf("\n");
  }
}

bool TableReporter::write_json(const std::string& path) const {
  nlohmann::ordered_json document{{"schema", 1}, {"rows", nlohmann::ordered_json::array()}};
  for (const Row& row : rows_) {
    nlohmann::ordered_json object{{"model", row.model}};
    for (const auto& [name, value] : row.values) object[name] = value;
    document["rows"].push_back(std::move(object));
  }
  std::ofstream out(path);
  out << document.dump(1) << '\n';
  return static_cast<bool>(out.flush());
}

int TableReporter::run_and_report(const std::string& json) {
  benchmark::RunSpecifiedBenchmarks(this);
  print();
  if (!json.empty() && !write_json(json)) {
    std::fprintf(stderr, "bench: cannot write %s\n", json.c_str());
    return 1;
  }
  return failed_ ? 1 : 0;
}

}  // namespace cdfr::bench
