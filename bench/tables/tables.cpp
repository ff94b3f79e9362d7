/// The tables of papers/huang-2001 and what its report tells, run again.
///   bench_tables --out FOLDER       all of them, as files of comma separated values
///   bench_tables --check FOLDER     counts of tables 2 and 3 against the files there: no times
#include <sys/utsname.h>

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "arguments.h"
#include "tables/contour_tables.h"
#include "tables/examples.h"
#include "tables/field_tables.h"
#include "tables/scaling.h"

namespace cdfr::bench {
namespace {

namespace fs = std::filesystem;

constexpr int rounds = 3;
/// Of one build in the scaling tables.
constexpr double most_seconds = 100;

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  utsname name{};
  ::uname(&name);
  return name.machine;
}

Csv machine_table() {
  const std::time_t now = std::time(nullptr);
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
  Csv table;
  table.add({{"date", date},
             {"processor", processor()},
             {"cores", std::to_string(std::thread::hardware_concurrency())}});
  return table;
}

bool write(const Csv& table, const fs::path& path) {
  if (table.write(path)) return true;
  std::fprintf(stderr, "bench: cannot write %s\n", path.c_str());
  return false;
}

int run_all(const fs::path& out) {
  fs::create_directories(out);
  // First, while no thread runs.
  bool written = write(example_table(), out / "examples.csv");
  written = write(machine_table(), out / "machine.csv") && written;
  written = write(part_table(), out / "table-1.csv") && written;
  written = write(field_table(simple_fields(32), rounds), out / "table-2.csv") && written;
  written = write(field_table(simple_fields(64), rounds), out / "table-3.csv") && written;
  written = write(field_table(large_fields(), rounds), out / "table-4.csv") && written;
  written = write(contour_table(simple_contours()), out / "tables-5-and-6.csv") && written;
  written = write(contour_table(large_contours()), out / "table-7.csv") && written;
  written = write(uniform_engine_table(), out / "uniform-engine.csv") && written;
  const Csv by_resolution = resolution_scaling(most_seconds), by_triangles = triangle_scaling();
  written = write(by_resolution, out / "resolution.csv") && written;
  written = write(by_triangles, out / "triangles.csv") && written;
  written = write(power_laws(by_resolution, by_triangles), out / "power-laws.csv") && written;
  return written ? 0 : 1;
}

/// The row of `known` with the same part, resolution and way; its size if there is none.
std::size_t find(const Csv& known, const Csv& table, std::size_t row) {
  std::size_t at = 0;
  const auto same = [&](const char* column) { return known.at(at, column) == table.at(row, column); };
  while (at < known.size() && !(same("part") && same("resolution") && same("way"))) ++at;
  return at;
}

int count_differences(const Csv& table, const fs::path& path) {
  const Csv known = Csv::read(path);
  int wrong = table.size() == known.size() ? 0 : 1;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const std::size_t at = find(known, table, row);
    for (const char* column : {"inside", "surface", "outside", "surface_mean", "inside_mean", "stated_kb"}) {
      const std::string was = at < known.size() ? known.at(at, column) : "nothing";
      if (was == table.at(row, column)) continue;
      std::fprintf(stderr, "%s %s, %s: %s is %s, in %s it was %s\n", table.at(row, "part").c_str(),
                   table.at(row, "resolution").c_str(), table.at(row, "way").c_str(), column,
                   table.at(row, column).c_str(), path.c_str(), was.c_str());
      ++wrong;
    }
  }
  std::printf("%s: %zu rows, %d differences\n", path.filename().c_str(), table.size(), wrong);
  return wrong;
}

int check(const fs::path& folder) {
  const int wrong = count_differences(field_table(simple_fields(32), 0), folder / "table-2.csv") +
                    count_differences(field_table(simple_fields(64), 0), folder / "table-3.csv");
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace cdfr::bench

int main(int count, char** arguments) {
  using namespace cdfr::bench;
  const std::string out = take_value(count, arguments, "--out");
  const std::string known = take_value(count, arguments, "--check");
  if (count != 1 || out.empty() == known.empty()) {
    std::fprintf(stderr, "usage: bench_tables --out FOLDER | --check FOLDER\n");
    return 2;
  }
  return out.empty() ? check(known) : run_all(out);
}
