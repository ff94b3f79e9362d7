#include "text_report.h"

#include <algorithm>

namespace cdfr::command {
namespace {

constexpr std::size_t label_width = 24;

}  // namespace

void TextReport::line(const std::string& label, const std::string& said) {
  const std::size_t gap = label.size() < label_width ? label_width - label.size() : 1;
  text_ += "  " + label + std::string(gap, ' ') + said + "\n";
}

void TextReport::table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text_ += std::string(2 + widths[i] - row[i].size(), ' ') + row[i];
    }
    text_ += "\n";
  }
}

}  // namespace cdfr::command
