#include "thickness_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "binary.h"
#include "number_text.h"

namespace cdfr::command {
namespace {

/// Rows turned into bytes at a time.
constexpr std::size_t block_rows = 16384;

constexpr std::array<const char*, 11> measures{"x",         "y",     "z",  "nx", "ny", "nz",
                                               "thickness", "error", "ox", "oy", "oz"};
constexpr std::array<const char*, 4> numbers{"triangle", "opposite", "patch", "opposite_patch"};

std::array<double, 11> measures_of(const ThicknessSample& s) noexcept {
  const bool unmet = std::isnan(s.thickness);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Vec3 o = unmet ? Vec3{none, none, none} : s.opposite_point;
  return {s.position.x, s.position.y,           s.position.z, s.normal.x, s.normal.y, s.normal.z,
          s.thickness,  unmet ? none : s.error, o.x,          o.y,        o.z};
}

std::array<std::uint32_t, 4> numbers_of(const ThicknessSample& s) noexcept {
  return {s.triangle, s.opposite, s.patch, s.opposite_patch};
}

std::string number_text(std::uint32_t number) { return number == no_index ? "-1" : std::to_string(number); }

void append_csv(std::string& text, const ThicknessSample& sample) {
  for (const double measure : measures_of(sample)) {
    append_exact(text, measure);
    text += ',';
  }
  for (const std::uint32_t number : numbers_of(sample)) text += number_text(number) + ",";
  append_exact(text, sample.area);
  text += sample.at_edge ? ",1," : ",0,";
  append_exact(text, sample.facet);
  text += sample.opposed ? ",1\n" : ",0\n";
}

void append_npy(std::string& bytes, const ThicknessSample& sample) {
  for (const double measure : measures_of(sample)) append_bytes(bytes, measure);
  for (const std::uint32_t number : numbers_of(sample))
    append_bytes(bytes, number == no_index ? -1.0 : static_cast<double>(number));
  append_bytes(bytes, sample.area);
  append_bytes(bytes, sample.at_edge ? 1.0 : 0.0);
  append_bytes(bytes, sample.facet);
  append_bytes(bytes, sample.opposed ? 1.0 : 0.0);
}

void append_ply(std::string& bytes, const ThicknessSample& sample) {
  for (const double measure : measures_of(sample)) append_bytes(bytes, measure);
  for (const std::uint32_t number : numbers_of(sample)) append_bytes(bytes, number);
  append_bytes(bytes, sample.area);
  bytes += static_cast<char>(sample.at_edge);
  append_bytes(bytes, sample.facet);
  bytes += static_cast<char>(sample.opposed);
}

std::string csv_header() {
  std::string text;
  for (const char* name : measures) text += std::string(name) + ",";
  for (const char* name : numbers) text += std::string(name) + ",";
  return text + "area,at_edge,facet,opposed\n";
}

std::string ply_header(std::size_t rows) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(rows) + "\n";
  for (const char* name : measures) text += std::string("property double ") + name + "\n";
  for (const char* name : numbers) text += std::string("property uint ") + name + "\n";
  return text +
         "property double area\nproperty uchar at_edge\nproperty double facet\nproperty uchar "
         "opposed\nend_header\n";
}

}  // namespace

void write_thickness_table(ByteSink& sink, std::span<const ThicknessSample> samples,
                           const std::string& extension) {
  void (*append)(std::string&, const ThicknessSample&) = append_csv;
  if (extension == ".npy") {
    append = append_npy;
    sink.write(npy_header("(" + std::to_string(samples.size()) + ", 19)"));
  } else if (extension == ".ply") {
    append = append_ply;
    sink.write(ply_header(samples.size()));
  } else {
    sink.write(csv_header());
  }
  std::string block;
  for (std::size_t first = 0; first < samples.size(); first += block_rows) {
    block.clear();
    for (const ThicknessSample& sample : samples.subspan(first, std::min(block_rows, samples.size() - first)))
      append(block, sample);
    sink.write(block);
  }
}

}  // namespace cdfr::command
