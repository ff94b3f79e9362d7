/// A field of a part of many millions of triangles, built on disk in bounded memory; then read through the
/// map.
///   bench_memory [--copies N] [--memory MIB] [--folder FOLDER] [--json FILE]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "arguments.h"
#include "cdfr/export/write.h"
#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"
#include "cdfr/store/build_file.h"
#include "cdfr/store/store.h"
#include "peak_memory.h"
#include "random.h"

namespace cdfr::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

bool told(const Result<FileBuildReport>& result) {
  if (!result) std::fprintf(stderr, "bench: %s\n", result.error().text.c_str());
  return static_cast<bool>(result);
}

/// Reads a file once, so that it is in the page cache if that has room for it.
void warm(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> bytes(std::size_t{1} << 22);
  while (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
  }
}

double seconds_for(const Field& field, const std::vector<Vec3>& points) {
  const auto start = Clock::now();
  double sum = 0;
  for (const Vec3& p : points) sum += field.distance(p);
  if (sum == 0.5) std::puts("");  // or the compiler sees that nobody wants it
  return seconds_since(start);
}

/// Nanoseconds a query for each of the fields, which take turns: the least of several rounds.
std::vector<double> query_ns(const std::vector<Field>& fields, const std::vector<Vec3>& points) {
  std::vector<double> least(fields.size(), 1e30);
  for (int round = 0; round < 9; ++round) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const double ns = seconds_for(fields[i], points) * 1e9 / static_cast<double>(points.size());
      least[i] = std::min(least[i], ns);
    }
  }
  return least;
}

int run(int count, char** arguments) {
  const auto number = [&](const char* name, double otherwise) {
    const std::string word = take_value(count, arguments, name);
    return word.empty() ? otherwise : std::atof(word.c_str());
  };
  const auto copies = static_cast<std::uint64_t>(number("--copies", 148));
  const double memory = number("--memory", 1024);
  const std::string json = take_value(count, arguments, "--json");
  const std::string where = take_value(count, arguments, "--folder");
  const std::filesystem::path folder =
      (where.empty() ? std::filesystem::temp_directory_path() : std::filesystem::path(where)) /
      "cdfr-bench-memory";
  std::filesystem::create_directories(folder);
  const auto mesh = folder / "part.stl", bounded = folder / "bounded.cdfr",
             unbounded = folder / "unbounded.cdfr";

  // In children, so that none of it stays in this process's memory.
  const Measured made = in_process([&] {
    const Result<Mesh> part = make_part("cylinder-head", copies);
    return part && write_mesh(part->view(), mesh);
  });
  FileBuildOptions options;
  options.memory = static_cast<std::uint64_t>(memory * 1048576);
  const Measured tight = in_process([&] { return told(build_file(mesh, bounded, options)); });
  const Measured free = in_process([&] { return told(build_file(mesh, unbounded)); });
  if (!made.done || !tight.done || !free.done) return 1;
  std::filesystem::remove(unbounded);

  warm(bounded);
  const auto start = Clock::now();
  Result<StoredField> stored = load(bounded);
  if (!stored) return 1;
  const Box box = stored->field.bounds();
  static_cast<void>(stored->field.distance(box.lo));
  const double first_ms = seconds_since(start) * 1e3;
  Random random(1);
  std::vector<Vec3> points(100000);
  for (Vec3& p : points) p = random.in(box);
  const std::string file_size = std::to_string(std::filesystem::file_size(bounded));
  // The same bytes on the heap: a packed file is unpacked there.
  const auto packed = folder / "packed.cdfr";
  double mapped_ns = 0, heap_ns = 0;
  if (save(stored->field, packed, "", Packing::zstd)) {
    if (const Result<StoredField> whole = load(packed)) {
      warm(bounded);
      const std::vector<double> ns = query_ns({stored->field, whole->field}, points);
      mapped_ns = ns[0];
      heap_ns = ns[1];
    }
  }
  const double triangles = static_cast<double>(stored->field.report().triangles);
  const nlohmann::json row{{"triangles", triangles},      {"file_bytes", std::stod(file_size)},
                           {"memory_MiB", memory},        {"bounded_peak_MiB", tight.peak},
                           {"bounded_s", tight.seconds},  {"unbounded_peak_MiB", free.peak},
                           {"unbounded_s", free.seconds}, {"time_ratio", tight.seconds / free.seconds},
                           {"first_answer_ms", first_ms}, {"mapped_ns", mapped_ns},
                           {"heap_ns", heap_ns}};
  std::printf("%.0f triangles, field %.2f GB\n", triangles, std::stod(file_size) / 1e9);
  std::printf(
      "bounded by %.0f MiB: peak %.0f MiB anonymous, %.1f s; unbounded: %.0f MiB, %.1f s; %.2f times as "
      "long\n",
      memory, tight.peak, tight.seconds, free.peak, free.seconds, tight.seconds / free.seconds);
  std::printf("load to the first answer: %.1f ms\n", first_ms);
  std::printf("a random query through the map %.0f ns, on the heap %.0f ns\n", mapped_ns, heap_ns);
  if (!json.empty()) std::ofstream(json) << row.dump(1) << '\n';
  std::filesystem::remove_all(folder);
  return tight.peak < memory ? 0 : 1;
}

}  // namespace
}  // namespace cdfr::bench

int main(int count, char** arguments) { return cdfr::bench::run(count, arguments); }
