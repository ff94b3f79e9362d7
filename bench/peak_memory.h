/// Work in a process of its own, whose anonymous memory is watched.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace cdfr::bench {

/// Of a process now, in MiB; 0 if it is gone.
inline double anonymous_memory(pid_t process = ::getpid()) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("RssAnon:", 0) == 0) return std::atof(line.c_str() + 8) / 1024;
  }
  return 0;
}

struct Measured {
  double seconds = 0, peak = 0;
  bool done = false;
};

/// work() says whether it succeeded. Precondition: no other thread runs that the work needs.
template <class Work>
Measured in_process(Work work) {
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work() ? 0 : 1);
  Measured measured;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    measured.peak = std::max(measured.peak, anonymous_memory(child));
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  measured.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  measured.done = status == 0;
  return measured;
}

}  // namespace cdfr::bench
