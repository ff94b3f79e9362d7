#include "peers_report.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "system.h"
#include "targets.h"

namespace cdfr::bench {
namespace {

constexpr const char* workloads[] = {"random", "near",   "far",   "batch", "grid",
                                     "build",  "batch2", "grid2", "build2"};

void print_cell(const Sheet& sheet, const std::string& system, const std::string& workload) {
  const Rounds* rounds = sheet.find(system, workload);
  if (rounds == nullptr) return (void)std::printf("  %12s %4s", "-", "-");
  std::printf("  %12.1f %3.0f%%", median(*rounds), 100 * spread(*rounds));
}

void print_ratio(const Sheet& sheet, const std::string& system, const std::string& workload) {
  const Rounds ratios = sheet.ratios(system, workload);
  if (ratios.empty()) return (void)std::printf(" %8s %4s", "-", "-");
  std::printf(" %7.2fx %3.0f%%", median(ratios), 100 * spread(ratios));
}

void print_sheet(const Sheet& sheet) {
  const Rounds* miss = sheet.find("machine", "miss");
  std::printf("\n%s: %.0f triangles, %.0f points checked, a dependent miss takes %.0f ns\n",
              sheet.model.c_str(), sheet.fact("cdfr", "triangles"), sheet.fact("cdfr", "checked"),
              miss ? median(*miss) : NAN);
  std::printf("%-12s", "ns");
  for (const SystemKind& kind : system_kinds()) {
    std::printf("  %12s %4s", kind.name, "+-");
    if (kind.name != std::string("cdfr")) std::printf(" %8s %4s", "ratio", "+-");
  }
  std::printf("\n");
  for (const char* workload : workloads) {
    std::printf("%-12s", workload);
    for (const SystemKind& kind : system_kinds()) {
      print_cell(sheet, kind.name, workload);
      if (kind.name != std::string("cdfr")) print_ratio(sheet, kind.name, workload);
    }
    std::printf("\n");
  }
  for (const char* fact : {"bytes", "worst_error"}) {
    std::printf("%-12s", fact);
    for (const SystemKind& kind : system_kinds()) {
      std::printf("  %12.4g     ", sheet.fact(kind.name, fact));
      if (kind.name != std::string("cdfr")) std::printf("%14s", "");
    }
    std::printf("\n");
  }
}

void print_medians(const std::vector<Sheet>& sheets) {
  std::printf("\nmedian of the ratios of %zu models (worst, best)\n%-12s", sheets.size(), "");
  for (const SystemKind& kind : system_kinds()) {
    if (kind.name != std::string("cdfr")) std::printf("  %28s", kind.name);
  }
  std::printf("\n");
  for (const char* workload : {"random", "near", "far", "batch", "grid", "build"}) {
    std::printf("%-12s", workload);
    for (const SystemKind& kind : system_kinds()) {
      if (kind.name == std::string("cdfr")) continue;
      Rounds all;
      for (const Sheet& sheet : sheets) {
        if (const Rounds ratios = sheet.ratios(kind.name, workload); !ratios.empty())
          all.push_back(median(ratios));
      }
      if (all.empty()) continue;
      const auto [least, most] = std::minmax_element(all.begin(), all.end());
      std::printf("  %8.2fx (%7.2f, %7.2f)", median(all), *least, *most);
    }
    std::printf("\n");
  }
}

void print_targets(const std::vector<Sheet>& sheets) {
  std::printf("\n%-55s  %9s  %9s\n", "target", "wanted", "measured");
  for (const Target& target : targets(sheets)) {
    if (std::isnan(target.measured)) continue;
    std::printf("%-55s  %2s %6.4g  %9.3g  %s\n", target.what.c_str(),
                target.at_least ? ">=" : "<=", target.wanted, target.measured,
                target.met() ? "met" : "not met");
  }
}

nlohmann::ordered_json row(const Sheet& sheet, const std::string& system, const std::string& workload,
                           const Rounds& rounds) {
  const bool two_threads = workload.ends_with('2');
  nlohmann::ordered_json object{
      {"mesh", sheet.model},
      {"triangles", sheet.fact("cdfr", "triangles")},
      {"system", system},
      {"workload", two_threads ? workload.substr(0, workload.size() - 1) : workload},
      {"threads", two_threads ? 2 : 1},
      {"ns", median(rounds)},
      {"ns_spread", spread(rounds)}};
  const Rounds ratios = sheet.ratios(system, workload);
  object["ratio"] = median(ratios);
  object["ratio_spread"] = spread(ratios);
  object["rounds"] = rounds.size();
  if (const Rounds* build = sheet.find(system, "build")) object["build_s"] = median(*build) * 1e-9;
  for (const char* fact : {"bytes", "checked", "worst_error"}) object[fact] = sheet.fact(system, fact);
  return object;
}

}  // namespace

void print_report(const std::vector<Sheet>& sheets) {
  for (const Sheet& sheet : sheets) print_sheet(sheet);
  print_medians(sheets);
  print_targets(sheets);
}

bool write_report(const std::vector<Sheet>& sheets, const std::string& path) {
  nlohmann::ordered_json document{{"schema", 1}, {"rows", nlohmann::ordered_json::array()}};
  document["targets"] = nlohmann::ordered_json::array();
  for (const Sheet& sheet : sheets) {
    for (const auto& [system, times] : sheet.times) {
      for (const auto& [workload, rounds] : times)
        document["rows"].push_back(row(sheet, system, workload, rounds));
    }
  }
  for (const Target& target : targets(sheets)) {
    document["targets"].push_back({{"what", target.what},
                                   {target.at_least ? "at_least" : "at_most", target.wanted},
                                   {"measured", target.measured},
                                   {"met", target.met()}});
  }
  std::ofstream out(path);
  out << document.dump(1) << '\n';
  return static_cast<bool>(out.flush());
}

}  // namespace cdfr::bench
