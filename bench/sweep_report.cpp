#include "sweep_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

namespace cdfr::bench {
namespace {

constexpr double query_counts[] = {1, 1e3, 1e6, 1e9};

struct Cost {
  double build_s, random_ns, near_ns, bytes;

  double seconds(double queries) const noexcept { return build_s + queries * random_ns * 1e-9; }
};

Cost cost(const Sheet& sheet, const std::string& name) {
  const auto time = [&](const char* what) {
    const Rounds* rounds = sheet.find(name, what);
    return rounds == nullptr ? std::numeric_limits<double>::quiet_NaN() : median(*rounds);
  };
  return {time("build") * 1e-9, time("random"), time("near"), sheet.fact(name, "bytes")};
}

/// Random queries from which on `ours`, built for them, takes less time in all than `other`; infinite if it
/// never does, 0 if it always does.
double break_even(const Cost& ours, const Cost& other) {
  const double longer_build_ns = (ours.build_s - other.build_s) * 1e9;
  const double gain_ns = other.random_ns - ours.random_ns;
  if (gain_ns <= 0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, longer_build_ns / gain_ns);
}

/// Those that a field is compared with.
std::vector<std::string> rivals() {
  std::vector<std::string> names{bvh_name};
  for (const SystemKind& kind : peer_kinds()) names.push_back(kind.name);
  return names;
}

bool is_rival(const std::string& name) {
  const std::vector<std::string> names = rivals();
  return std::find(names.begin(), names.end(), name) != names.end();
}

void print_head(const Sheet& sheet) {
  std::printf("\n%s: %.0f triangles; 'from' is the number of queries from which on it pays, build included\n",
              sheet.model.c_str(), sheet.fact(bvh_name, "triangles"));
  std::printf("%-20s %9s %9s %9s %9s %9s", "", "MB", "B/triang.", "build_s", "random_ns", "near_ns");
  for (const double queries : query_counts) std::printf(" %5.0e in s", queries);
  for (const std::string& rival : rivals()) std::printf(" %12s", ("from:" + rival).c_str());
  std::printf("\n");
}

void print_sheet(const Sheet& sheet, const std::vector<Setting>& settings) {
  print_head(sheet);
  for (const Setting& setting : settings) {
    const Cost c = cost(sheet, setting.name);
    std::printf("%-20s %9.2f %9.0f %9.3f %9.0f %9.0f", setting.name.c_str(), c.bytes / 1e6,
                c.bytes / sheet.fact(setting.name, "triangles"), c.build_s, c.random_ns, c.near_ns);
    for (const double queries : query_counts) std::printf(" %10.4g", c.seconds(queries));
    if (!is_rival(setting.name)) {
      for (const std::string& rival : rivals()) {
        const double from = break_even(c, cost(sheet, rival));
        if (std::isinf(from)) {
          std::printf(" %12s", "never");
        } else {
          std::printf(" %12.3g", from);
        }
      }
    }
    std::printf("\n");
  }
}

nlohmann::ordered_json row(const Sheet& sheet, const Setting& setting) {
  const Cost c = cost(sheet, setting.name);
  nlohmann::ordered_json object{
      {"mesh", sheet.model},     {"triangles", sheet.fact(setting.name, "triangles")},
      {"setting", setting.name}, {"bytes", c.bytes},
      {"build_s", c.build_s},    {"random_ns", c.random_ns},
      {"near_ns", c.near_ns}};
  for (const double queries : query_counts)
    object["seconds"].push_back({{"queries", queries}, {"s", c.seconds(queries)}});
  if (is_rival(setting.name)) return object;
  if (setting.options.expected_queries > 0) {
    object["expected_queries"] = setting.options.expected_queries;
  } else {
    object["max_triangles_per_leaf"] = setting.options.max_triangles_per_leaf;
  }
  object["max_level"] = setting.options.max_level;
  for (const std::string& rival : rivals()) object["break_even"][rival] = break_even(c, cost(sheet, rival));
  return object;
}

}  // namespace

void print_sweep(const std::vector<Sheet>& sheets, const std::vector<Setting>& settings) {
  for (const Sheet& sheet : sheets) print_sheet(sheet, settings);
}

bool write_sweep(const std::vector<Sheet>& sheets, const std::vector<Setting>& settings,
                 const std::string& path) {
  nlohmann::ordered_json document{{"schema", 1}, {"rows", nlohmann::ordered_json::array()}};
  for (const Sheet& sheet : sheets) {
    for (const Setting& setting : settings) document["rows"].push_back(row(sheet, setting));
  }
  std::ofstream out(path);
  out << document.dump(1) << '\n';
  return static_cast<bool>(out.flush());
}

}  // namespace cdfr::bench
