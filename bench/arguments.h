/// Arguments of the benches' own; those that are left belong to Google Benchmark.
#pragma once

#include <algorithm>
#include <string>

namespace cdfr::bench {

/// Takes "NAME" out of the arguments; false if it is not there.
inline bool take_flag(int& count, char** arguments, const std::string& name) {
  char** end = arguments + count;
  char** at = std::find(arguments + 1, end, name);
  if (at == end) return false;
  std::copy(at + 1, end, at);
  arguments[--count] = nullptr;
  return true;
}

/// Takes "NAME VALUE" out of the arguments; empty if it is not there.
inline std::string take_value(int& count, char** arguments, const std::string& name) {
  for (int i = 1; i + 1 < count; ++i) {
    if (arguments[i] != name) continue;
    const std::string value = arguments[i + 1];
    std::copy(arguments + i + 2, arguments + count, arguments + i);
    count -= 2;
    arguments[count] = nullptr;
    return value;
  }
  return {};
}

}  // namespace cdfr::bench
