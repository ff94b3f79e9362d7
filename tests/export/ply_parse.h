/// A strict reader of binary little endian PLY, for tests: any surprise is a test failure.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace cdfr {

template <class Number>
Number little_endian_at(const std::string& bytes, std::size_t offset) {
  Number value{};
  EXPECT_LE(offset + sizeof value, bytes.size());
  if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<std::string> properties;  ///< "double x"
  std::vector<std::vector<double>> rows;
};

class PlyParse {
 public:
  explicit PlyParse(const std::string& bytes) : bytes_(bytes) {
    parse_header();
    for (PlyElement& element : elements) parse_rows(element);
    EXPECT_EQ(at_, bytes_.size()) << "bytes after the last element";
  }
  std::vector<PlyElement> elements;
  std::vector<std::string> comments;

 private:
  std::string line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) return ADD_FAILURE() << "header does not end", "end_header";
    const std::string text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return text;
  }

  void parse_header() {
    EXPECT_EQ(line(), "ply");
    EXPECT_EQ(line(), "format binary_little_endian 1.0");
    for (std::string text = line(); text != "end_header"; text = line()) {
      EXPECT_EQ(text.find("  "), std::string::npos) << text;
      std::istringstream words(text);
      std::string word;
      words >> word;
      if (word == "comment") {
        comments.push_back(text.substr(8));
        continue;
      }
      if (word == "element") {
        PlyElement element;
        std::string count;
        words >> element.name >> count;
        element.count = std::stoull(count);
        EXPECT_EQ(std::to_string(element.count), count) << "no zeros in front";
        elements.push_back(element);
      } else {
        EXPECT_EQ(word, "property");
        elements.back().properties.push_back(text.substr(9));
      }
    }
  }

  template <class Number>
  double next() {
    const auto value = little_endian_at<Number>(bytes_, at_);
    at_ += sizeof value;
    return static_cast<double>(value);
  }

  void parse_rows(PlyElement& element) {
    for (std::size_t i = 0; i < element.count && at_ < bytes_.size(); ++i) {
      std::vector<double> row;
      for (const std::string& property : element.properties) {
        const std::string type = property.substr(0, property.find(' '));
        if (type == "double") {
          row.push_back(next<double>());
        } else if (type == "uint") {
          row.push_back(next<std::uint32_t>());
        } else if (type == "uchar") {
          row.push_back(next<std::uint8_t>());
        } else {
          EXPECT_EQ(property, "list uchar uint vertex_indices");
          const double length = next<std::uint8_t>();
          EXPECT_EQ(length, 3);
          for (int k = 0; k < 3; ++k) row.push_back(next<std::uint32_t>());
        }
      }
      element.rows.push_back(row);
    }
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace cdfr
