#include "tables/csv.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace cdfr::bench {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

void write_line(std::ofstream& out, const std::vector<std::string>& cells, std::size_t columns) {
  for (std::size_t i = 0; i < columns; ++i) out << (i == 0 ? "" : ",") << (i < cells.size() ? cells[i] : "");
  out << '\n';
}

}  // namespace

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::size_t Csv::column(const std::string& name) {
  const auto found = std::ranges::find(columns_, name);
  if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
  columns_.push_back(name);
  return columns_.size() - 1;
}

void Csv::add(const CsvRow& row) {
  std::vector<std::string> cells;
  for (const auto& [name, value] : row) {
    const std::size_t place = column(name);
    if (cells.size() <= place) cells.resize(place + 1);
    cells[place] = value;
  }
  rows_.push_back(std::move(cells));
}

std::string Csv::at(std::size_t row, const std::string& column) const {
  const auto found = std::ranges::find(columns_, column);
  const auto place = static_cast<std::size_t>(found - columns_.begin());
  return found != columns_.end() && place < rows_[row].size() ? rows_[row][place] : "";
}

bool Csv::write(const std::filesystem::path& path) const {
  std::ofstream out(path);
  write_line(out, columns_, columns_.size());
  for (const auto& row : rows_) write_line(out, row, columns_.size());
  return static_cast<bool>(out.flush());
}

Csv Csv::read(const std::filesystem::path& path) {
  Csv csv;
  std::ifstream in(path);
  std::string line;
  if (std::getline(in, line)) csv.columns_ = cells_of(line);
  while (std::getline(in, line)) csv.rows_.push_back(cells_of(line));
  return csv;
}

}  // namespace cdfr::bench
