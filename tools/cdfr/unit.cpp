#include "unit.h"

#include <array>
#include <utility>

#include "terminal_text.h"

namespace cdfr::command {
namespace {

constexpr std::size_t longest_label = 32;
constexpr std::array<std::pair<const char*, double>, 12> lengths{{{"um", 1e-6},
                                                                  {"mm", 1e-3},
                                                                  {"cm", 1e-2},
                                                                  {"dm", 1e-1},
                                                                  {"m", 1},
                                                                  {"km", 1e3},
                                                                  {"mil", 2.54e-5},
                                                                  {"in", 0.0254},
                                                                  {"inch", 0.0254},
                                                                  {"ft", 0.3048},
                                                                  {"foot", 0.3048},
                                                                  {"yd", 0.9144}}};

}  // namespace

std::optional<double> metres_in(const std::string& unit) {
  for (const auto& [label, metres] : lengths) {
    if (unit == label) return metres;
  }
  return std::nullopt;
}

std::string unit_fault(const std::string& unit) {
  if (unit.size() > longest_label) return "is longer than 32 bytes";
  if (terminal_text(unit) != unit) return "has a character that cannot be printed";
  return {};
}

std::string after_number(const std::string& unit) {
  return unit.empty() ? std::string() : " " + terminal_text(unit);
}

}  // namespace cdfr::command
