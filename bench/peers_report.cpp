#include "peers_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "system.h"
#include "targets.h"

namespace cdfr::bench {
namespace {

/// A workload as the table shows it: builds are too long to be read in nanoseconds.
struct Line {
  const char* workload;
  const char* title;
  double unit_ns;
};
constexpr Line lines[] = {
    {"random", "random, ns", 1},    {"near", "near, ns", 1},       {"far", "far, ns", 1},
    {"batch", "batch, ns", 1},      {"grid", "grid, ns", 1},       {"build", "build, ms", 1e6},
    {"total1", "1 query, ms", 1e6}, {"total1000", "1e3, ms", 1e6}, {"total100000", "1e5, ms", 1e6},
    {"batch2", "batch x2, ns", 1},  {"grid2", "grid x2, ns", 1},   {"build2", "build x2, ms", 1e6},
};

void print_time(const Sheet& sheet, const char* system, const Line& line) {
  const Rounds* rounds = sheet.find(system, line.workload);
  if (rounds == nullptr) return (void)std::printf("  %10s %4s", "-", "");
  std::printf("  %10.1f %3.0f%%", median(*rounds) / line.unit_ns, 100 * spread(*rounds));
}

void print_ratio(const Sheet& sheet, const char* system, const Line& line) {
  const Rounds ratios = sheet.ratios(system, line.workload);
  if (ratios.empty()) return (void)std::printf(" %8s %4s", "-", "");
  std::printf(" %7.3gx %3.0f%%", median(ratios), 100 * spread(ratios));
}

void print_fact(const Sheet& sheet, const char* title, const char* fact, double unit) {
  std::printf("%-14s  %10.3g %4s", title, sheet.fact("cdfr", fact) / unit, "");
  for (const SystemKind& peer : peer_kinds()) {
    std::printf("  %10.3g %4s %8s %4s", sheet.fact(peer.name, fact) / unit, "", "", "");
  }
  std::printf("\n");
}

void print_sheet(const Sheet& sheet) {
  const Rounds* miss = sheet.find("machine", "miss");
  const double triangles = sheet.fact("cdfr", "triangles");
  std::printf(
      "\n%s: %.0f triangles; %.0f points checked against brute force; a dependent miss takes %.0f ns\n",
      sheet.model.c_str(), triangles, sheet.fact("cdfr", "checked"), miss ? median(*miss) : NAN);
  std::printf("%-14s  %10s %4s", "", "cdfr", "+-");
  for (const SystemKind& peer : peer_kinds())
    std::printf("  %10s %4s %8s %4s", peer.name, "+-", "ratio", "+-");
  std::printf("\n");
  for (const Line& line : lines) {
    std::printf("%-14s", line.title);
    print_time(sheet, "cdfr", line);
    for (const SystemKind& peer : peer_kinds()) {
      print_time(sheet, peer.name, line);
      print_ratio(sheet, peer.name, line);
    }
    std::printf("\n");
  }
  print_fact(sheet, "bytes/triangle", "bytes", triangles);
  print_fact(sheet, "worst error", "worst_error", 1);
}

void print_median_ratio(const std::vector<Sheet>& sheets, const char* peer, const char* workload) {
  Rounds all;
  for (const Sheet& sheet : sheets) {
    if (const Rounds ratios = sheet.ratios(peer, workload); !ratios.empty()) all.push_back(median(ratios));
  }
  if (all.empty()) return (void)std::printf("  %28s", "-");
  const auto [least, most] = std::minmax_element(all.begin(), all.end());
  std::printf("  %8.3gx (%7.3g, %7.3g)", median(all), *least, *most);
}

void print_medians(const std::vector<Sheet>& sheets) {
  std::printf("\nover all models, how many times as long as cdfr: median (least, most); models: %zu\n%-14s",
              sheets.size(), "");
  for (const SystemKind& peer : peer_kinds()) std::printf("  %28s", peer.name);
  std::printf("\n");
  for (const char* workload :
       {"random", "near", "far", "batch", "grid", "build", "total1", "total1000", "total100000"}) {
    std::printf("%-14s", workload);
    for (const SystemKind& peer : peer_kinds()) print_median_ratio(sheets, peer.name, workload);
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
