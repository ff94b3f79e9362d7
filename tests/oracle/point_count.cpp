#include "oracle/point_count.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace cdfr::oracle {
namespace {

std::optional<std::size_t> wanted_points() {
  const char* text = std::getenv("CDFR_POINTS");
  if (text == nullptr) return std::nullopt;
  return std::strtoull(text, nullptr, 10);
}

}  // namespace

std::size_t point_count(std::size_t triangles) {
  if (const auto wanted = wanted_points()) {
    return std::max<std::size_t>(9, triangles > 200'000 ? *wanted / 20 : *wanted);
  }
  return triangles <= 20'000 ? 300 : 60;
}

bool short_run() { return wanted_points().value_or(0) < 1000; }

bool light_run() { return wanted_points().value_or(1000) < 100; }

}  // namespace cdfr::oracle
