/// A report for people: lines of a label and what it says, and tables.
#pragma once

#include <string>
#include <vector>

namespace cdfr::command {

class TextReport {
 public:
  explicit TextReport(std::string title) : text_(std::move(title) + "\n") {}

  void line(const std::string& label, const std::string& said);
  void blank() { text_ += "\n"; }
  /// Columns as wide as they need, aligned right; the first row is the header.
  void table(const std::vector<std::vector<std::string>>& rows);
  const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
};

}  // namespace cdfr::command
