/// Rows of named columns, as a file of comma separated values.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cdfr::bench {

/// A cell's column and what stands there.
using CsvRow = std::vector<std::pair<std::string, std::string>>;

/// Rounded to so many digits after the point.
std::string fixed(double value, int digits);

class Csv {
 public:
  /// Columns come in the order in which rows name them first.
  void add(const CsvRow& row);
  std::size_t size() const noexcept { return rows_.size(); }
  /// Empty if the row has no such column. Precondition: row < size().
  std::string at(std::size_t row, const std::string& column) const;
  /// False if it cannot be written.
  bool write(const std::filesystem::path& path) const;
  /// Without rows if it cannot be read. No cell holds a comma.
  static Csv read(const std::filesystem::path& path);

 private:
  std::size_t column(const std::string& name);

  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace cdfr::bench
