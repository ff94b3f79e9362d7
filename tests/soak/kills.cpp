/// Kills builds at random moments, again and again, and lets some of them end: the output is always a whole
/// old or a whole new file.
///   soak_kills [--kills N] [--seed S]
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "cdfr/export/write.h"
#include "cdfr/parts/part.h"
#include "cdfr/store/build_file.h"
#include "support/random.h"

namespace cdfr {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// This process itself never starts a thread, so that its children may.
pid_t start_build(const std::filesystem::path& mesh, const std::filesystem::path& output,
                  std::uint64_t memory) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  FileBuildOptions options;
  options.build.max_triangles_per_leaf = 160;
  options.memory = memory;
  Run run;
  run.threads = 2;
  const Result<FileBuildReport> built = build_file(mesh, output, options, run);
  if (!built) std::fprintf(stderr, "soak: %s\n", built.error().text.c_str());
  ::_exit(built ? 0 : 1);
}

int wait_for(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

int run(int count, char** arguments) {
  long kills = 1000, seed = 1;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string name = arguments[i];
    (name == "--kills" ? kills : seed) = std::atol(arguments[i + 1]);
  }
  std::string pattern = (std::filesystem::temp_directory_path() / "cdfr-soak-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) return 1;
  const std::filesystem::path folder = pattern, mesh = folder / "part.stl", output = folder / "field.cdfr";
  write_mesh(make_part("cylinder-head").value().view(), mesh).value();

  const auto start = std::chrono::steady_clock::now();
  if (wait_for(start_build(mesh, output, 0)) != 0) return 1;
  const double whole_us =
      std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  const std::string whole = bytes_of(output), old = "an older file";
  const auto put_old = [&] { std::ofstream(output, std::ios::binary) << old; };
  put_old();
  test::Random random(static_cast<std::uint64_t>(seed));
  long finished = 0, wrong = 0;
  for (long i = 0; i < kills; ++i) {
    const std::uint64_t memory = random.below(2) == 0 ? 0 : std::uint64_t{1} << 30;
    const pid_t child = start_build(mesh, output, memory);
    ::usleep(static_cast<useconds_t>(random.between(0, whole_us)));
    ::kill(child, SIGKILL);
    const int status = wait_for(child);
    if (random.below(20) == 0 && wait_for(start_build(mesh, output, memory)) != 0) ++wrong;
    const std::string now = bytes_of(output);
    const bool is_whole = now == whole;
    if (!is_whole && now != old) ++wrong;
    if (!is_whole && WIFEXITED(status)) ++wrong;
    if (is_whole) {
      ++finished;
      put_old();
    }
    if (wrong > 0) {
      std::fprintf(stderr, "soak: wrong after kill %ld of seed %ld\n", i + 1, seed);
      break;
    }
  }
  std::printf("%ld kills, %ld builds came to their end, %ld wrong\n", kills, finished, wrong);
  std::filesystem::remove_all(folder);
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace cdfr

int main(int count, char** arguments) { return cdfr::run(count, arguments); }
