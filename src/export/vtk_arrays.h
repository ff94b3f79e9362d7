/// Arrays of VTK's XML files as "appended" raw bytes: the XML says where each lies, the bytes follow it all.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/whole_file.h"
#include "export/little_endian.h"

namespace cdfr {

class VtkArrays {
 public:
  /// `fill(i, record)` puts row i, `row_bytes` long, in the record when write() comes to it. Gives the
  /// element that stands for the array in the XML.
  template <std::size_t row_bytes, class Fill>
  std::string add(const std::string& type, const std::string& name, int components, std::uint64_t rows,
                  Fill fill) {
    const auto write = [rows, fill](WholeFile& file) -> Result<void> {
      for (std::uint64_t i = 0; i < rows; ++i) {
        Record<row_bytes> record;
        fill(i, record);
        if (auto written = file.write(record.bytes()); !written) return written;
      }
      return {};
    };
    return add_bytes("DataArray", type, name, components, rows * row_bytes, write);
  }

  /// Strings without zeros in them. `blanks` empty ones come first.
  std::string add_strings(const std::string& name, std::uint64_t blanks,
                          const std::vector<std::string>& texts);

  /// What follows the XML: each array behind its length in bytes.
  Result<void> write(WholeFile& file) const;

 private:
  using Write = std::function<Result<void>(WholeFile&)>;

  std::string add_bytes(const std::string& element, const std::string& type, const std::string& name,
                        int components, std::uint64_t bytes, Write write);

  std::uint64_t offset_ = 0;
  std::vector<std::pair<std::uint64_t, Write>> arrays_;
};

/// The same for what a whole file has, "field data", which may stand in the XML itself.
std::string vtk_field_numbers(const std::string& name, const std::vector<double>& values);
std::string vtk_field_strings(const std::string& name, const std::vector<std::string>& texts);

}  // namespace cdfr
