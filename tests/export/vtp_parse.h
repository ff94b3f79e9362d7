/// A strict reader of what write_painted calls .vtp, for tests: any surprise is a test failure.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "export/ply_parse.h"

namespace cdfr {

struct VtpArray {
  std::map<std::string, std::string> attributes;
  std::string bytes;  ///< as appended, or the text between the tags

  template <class Number>
  std::vector<Number> numbers() const {
    std::vector<Number> values;
    EXPECT_EQ(bytes.size() % sizeof(Number), 0U);
    for (std::size_t at = 0; at + sizeof(Number) <= bytes.size(); at += sizeof(Number))
      values.push_back(little_endian_at<Number>(bytes, at));
    return values;
  }
  /// Of appended strings: what stands before each zero.
  std::vector<std::string> strings() const { return cut(bytes); }
  /// Of strings in the XML: codes of bytes.
  std::vector<std::string> coded_strings() const {
    std::istringstream codes(bytes);
    std::string decoded;
    for (int code = 0; codes >> code;) decoded += static_cast<char>(code);
    return cut(decoded);
  }

 private:
  static std::vector<std::string> cut(const std::string& text) {
    std::vector<std::string> parts;
    std::size_t start = 0;
    for (std::size_t end = text.find('\0'); end != std::string::npos; end = text.find('\0', start)) {
      parts.push_back(text.substr(start, end - start));
      start = end + 1;
    }
    EXPECT_EQ(start, text.size()) << "the last string has its zero";
    return parts;
  }
};

class VtpParse {
 public:
  explicit VtpParse(const std::string& file) {
    const std::string start = "<AppendedData encoding=\"raw\">\n_", end = "\n</AppendedData>\n</VTKFile>\n";
    const std::size_t mark = file.find(start);
    EXPECT_NE(mark, std::string::npos);
    EXPECT_TRUE(file.ends_with(end));
    data_ = file.substr(mark + start.size());
    data_.resize(data_.size() - end.size());
    xml_ = file.substr(0, mark);
    while (at_ < xml_.size()) element();
    EXPECT_TRUE(open_.size() == 1 && open_[0] == "VTKFile") << "all elements are closed";
    EXPECT_EQ(used_, data_.size()) << "every appended byte belongs to an array";
  }

  std::map<std::string, std::string> piece;
  /// By "Section/Name", such as "PointData/thickness".
  std::map<std::string, VtpArray> arrays;
  std::map<std::string, std::string> scalars;  ///< active array of PointData, CellData

 private:
  using Attributes = std::map<std::string, std::string>;

  /// One tag, and the text up to the next one.
  void element() {
    EXPECT_EQ(xml_[at_], '<');
    const std::size_t end = xml_.find('>', at_), next = xml_.find('<', end);
    std::string tag = xml_.substr(at_ + 1, end - at_ - 1);
    const std::string text = xml_.substr(end + 1, next == std::string::npos ? next : next - end - 1);
    at_ = next == std::string::npos ? xml_.size() : next;
    if (tag[0] == '?') return;
    if (tag[0] == '/') {
      ASSERT_FALSE(open_.empty());
      EXPECT_EQ(tag.substr(1), open_.back());
      open_.pop_back();
      return;
    }
    const bool closed = tag.back() == '/';
    if (closed) tag.pop_back();
    start(tag, text);
    if (closed) open_.pop_back();
  }

  void start(const std::string& tag, const std::string& text) {
    const std::string name = tag.substr(0, tag.find(' '));
    const Attributes attributes = attributes_of(tag.substr(name.size()));
    if (name == "Piece") piece = attributes;
    if (attributes.count("Scalars") > 0) scalars[name] = attributes.at("Scalars");
    if (name == "DataArray" || name == "Array") {
      const bool appended = attributes.at("format") == "appended";
      arrays[open_.back() + "/" + attributes.at("Name")] = {attributes, appended ? data(attributes) : text};
    }
    open_.push_back(name);
  }

  static Attributes attributes_of(const std::string& text) {
    Attributes attributes;
    std::size_t at = 0;
    while (at < text.size()) {
      const std::size_t equals = text.find("=\"", at), end = text.find('"', equals + 2);
      EXPECT_EQ(text[at], ' ');
      attributes[text.substr(at + 1, equals - at - 1)] = text.substr(equals + 2, end - equals - 2);
      at = end + 1;
    }
    return attributes;
  }

  std::string data(const Attributes& attributes) {
    const std::size_t offset = std::stoull(attributes.at("offset"));
    const auto length = little_endian_at<std::uint64_t>(data_, offset);
    EXPECT_LE(offset + 8 + length, data_.size());
    used_ += 8 + length;
    return data_.substr(offset + 8, length);
  }

  std::string xml_, data_;
  std::size_t at_ = 0, used_ = 0;
  std::vector<std::string> open_;
};

}  // namespace cdfr
