#include "export/vtk_arrays.h"

#include <string_view>

#include "export/number_text.h"

namespace cdfr {
namespace {

std::string quoted(const std::string& key, const std::string& value) {
  return " " + key + "=\"" + value + "\"";
}

}  // namespace

std::string VtkArrays::add_bytes(const std::string& element, const std::string& type, const std::string& name,
                                 int components, std::uint64_t bytes, Write write) {
  const std::string text = "<" + element + quoted("type", type) + quoted("Name", name) +
                           quoted("NumberOfComponents", std::to_string(components)) +
                           quoted("format", "appended") + quoted("offset", std::to_string(offset_)) + "/>\n";
  offset_ += sizeof bytes + bytes;
  arrays_.emplace_back(bytes, std::move(write));
  return text;
}

std::string VtkArrays::add_strings(const std::string& name, std::uint64_t blanks,
                                   const std::vector<std::string>& texts) {
  std::string ends;
  for (const std::string& text : texts) ends += text + '\0';
  const std::uint64_t bytes = blanks + ends.size();
  const auto write = [blanks, ends = std::move(ends)](WholeFile& file) -> Result<void> {
    constexpr std::string_view zero("", 1);
    for (std::uint64_t i = 0; i < blanks; ++i) {
      if (auto written = file.write(zero); !written) return written;
    }
    return file.write(ends);
  };
  return add_bytes("Array", "String", name, 1, bytes, write);
}

Result<void> VtkArrays::write(WholeFile& file) const {
  for (const auto& [bytes, write] : arrays_) {
    Record<sizeof bytes> length;
    length.append(bytes);
    if (auto written = file.write(length.bytes()); !written) return written;
    if (auto written = write(file); !written) return written;
  }
  return {};
}

std::string vtk_field_numbers(const std::string& name, const std::vector<double>& values) {
  std::string text = "<DataArray" + quoted("type", "Float64") + quoted("Name", name) +
                     quoted("NumberOfTuples", std::to_string(values.size())) + quoted("format", "ascii") +
                     ">";
  for (const double value : values) append_number(text += ' ', value);
  return text + " </DataArray>\n";
}

/// As the codes of their bytes, so that XML takes any text, with a zero after each.
std::string vtk_field_strings(const std::string& name, const std::vector<std::string>& texts) {
  std::string text = "<Array" + quoted("type", "String") + quoted("Name", name) +
                     quoted("NumberOfTuples", std::to_string(texts.size())) + quoted("format", "ascii") + ">";
  for (const std::string& one : texts) {
    for (const char letter : one) text += " " + std::to_string(static_cast<unsigned char>(letter));
    text += " 0";
  }
  return text + " </Array>\n";
}

}  // namespace cdfr
