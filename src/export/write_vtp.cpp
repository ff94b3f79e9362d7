/// Points: the mesh's vertices, then balls, then labels. Cells, in VTK's order: one vertex cell a ball or
/// label, then the triangles. What further points and cells do not have is NaN, no_index or no text.
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "export/little_endian.h"
#include "export/paint.h"
#include "export/painted_formats.h"
#include "export/text_line.h"
#include "export/vtk_arrays.h"

namespace cdfr {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

class VtpFile {
 public:
  explicit VtpFile(const PaintedMesh& painted) noexcept
      : painted_(painted),
        paint_(painted),
        vertices_(painted.mesh.vertices.size()),
        triangles_(painted.mesh.triangles.size()),
        marks_(painted.balls.size() + painted.labels.size()) {}

  Result<void> write(WholeFile& file) {
    const std::string text = xml();
    if (auto written = file.write(text); !written) return written;
    if (auto written = arrays_.write(file); !written) return written;
    return file.write("\n</AppendedData>\n</VTKFile>\n");
  }

 private:
  std::string xml();
  std::string field_data() const;
  std::string piece_start() const;
  std::string data_start(const std::string& element, ArrayPlace place) const;
  std::string numbers(ArrayPlace place, std::uint64_t before, std::uint64_t after);
  std::string marks();
  std::string patches();
  std::string points();
  std::string mark_cells();
  std::string triangle_cells();

  const PaintedMesh& painted_;
  Paint paint_;
  std::uint64_t vertices_, triangles_, marks_;
  VtkArrays arrays_;
};

/// Statement by statement, for each call takes the next place among the appended arrays.
std::string VtpFile::xml() {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n";
  text += "<FieldData>\n" + field_data() + "</FieldData>\n";
  text += piece_start();
  text += data_start("PointData", ArrayPlace::vertex) + numbers(ArrayPlace::vertex, 0, marks_);
  text += marks() + "</PointData>\n";
  text += data_start("CellData", ArrayPlace::face) + numbers(ArrayPlace::face, marks_, 0);
  text += patches() + "</CellData>\n";
  text += "<Points>\n" + points() + "</Points>\n";
  text += "<Verts>\n" + mark_cells() + "</Verts>\n";
  text += "<Polys>\n" + triangle_cells() + "</Polys>\n";
  return text + "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
}

std::string VtpFile::field_data() const {
  std::string text;
  if (paint_.any()) {
    text += vtk_field_strings("painted", {range_text(painted_)});
    text += vtk_field_numbers("painted_range", {painted_.least, painted_.greatest});
  }
  text += vtk_field_strings("unit", {text_line(painted_.unit)});
  std::vector<std::string> notes;
  for (const std::string& note : painted_.notes) notes.push_back(text_line(note));
  return notes.empty() ? text : text + vtk_field_strings("notes", notes);
}

std::string VtpFile::piece_start() const {
  return "<Piece NumberOfPoints=\"" + std::to_string(vertices_ + marks_) + "\" NumberOfVerts=\"" +
         std::to_string(marks_) + "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(triangles_) + "\">\n";
}

std::string VtpFile::data_start(const std::string& element, ArrayPlace place) const {
  return "<" + element + (paint_.on(place) ? " Scalars=\"" + painted_.painted + "\"" : "") + ">\n";
}

/// The arrays of one place, and the colours if they are there; `before` and `after` rows are of marks.
std::string VtpFile::numbers(ArrayPlace place, std::uint64_t before, std::uint64_t after) {
  std::string text;
  for (const MeshArray& array : painted_.arrays) {
    if (array.place != place) continue;
    const auto values = array.values;
    text += arrays_.add<8>("Float64", array.name, 1, before + values.size() + after,
                           [values, before](std::uint64_t i, auto& record) {
                             const bool own = i >= before && i - before < values.size();
                             record.append(own ? values[i - before] : none);
                           });
  }
  if (!paint_.on(place)) return text;
  const std::uint64_t own = place == ArrayPlace::vertex ? vertices_ : triangles_;
  return text + arrays_.add<3>("UInt8", "colour", 3, before + own + after,
                               [this, before, own](std::uint64_t i, auto& record) {
                                 const Colour colour = i >= before && i - before < own
                                                           ? paint_.colour(i - before)
                                                           : painted_colour(none, 0, 1);
                                 for (const std::uint8_t channel : colour) record.append(channel);
                               });
}

std::string VtpFile::marks() {
  if (marks_ == 0) return {};
  std::string text =
      arrays_.add<8>("Float64", "radius", 1, vertices_ + marks_, [this](std::uint64_t i, auto& record) {
        const bool ball = i >= vertices_ && i - vertices_ < painted_.balls.size();
        record.append(ball ? painted_.balls[i - vertices_].radius : none);
      });
  std::vector<std::string> labels;
  for (const PaintedLabel& label : painted_.labels) labels.push_back(text_line(label.text));
  return text + arrays_.add_strings("label", vertices_ + painted_.balls.size(), labels);
}

std::string VtpFile::patches() {
  if (painted_.mesh.patches.empty()) return {};
  return arrays_.add<4>("UInt32", "patch", 1, marks_ + triangles_, [this](std::uint64_t i, auto& record) {
    record.append(i < marks_ ? no_index : painted_.mesh.patches[i - marks_]);
  });
}

std::string VtpFile::points() {
  return arrays_.add<24>("Float64", "points", 3, vertices_ + marks_, [this](std::uint64_t i, auto& record) {
    const std::uint64_t balls = painted_.balls.size();
    const Vec3 p = i < vertices_           ? painted_.mesh.vertices[i]
                   : i - vertices_ < balls ? painted_.balls[i - vertices_].centre
                                           : painted_.labels[i - vertices_ - balls].place;
    for (const double coordinate : {p.x, p.y, p.z}) record.append(coordinate);
  });
}

std::string VtpFile::mark_cells() {
  std::string text = arrays_.add<8>("Int64", "connectivity", 1, marks_,
                                    [this](std::uint64_t i, auto& record) { record.append(vertices_ + i); });
  return text += arrays_.add<8>("Int64", "offsets", 1, marks_,
                                [](std::uint64_t i, auto& record) { record.append(i + 1); });
}

std::string VtpFile::triangle_cells() {
  std::string text =
      arrays_.add<24>("Int64", "connectivity", 1, triangles_, [this](std::uint64_t i, auto& record) {
        for (const std::uint32_t corner : painted_.mesh.triangles[i]) record.append(std::uint64_t{corner});
      });
  return text += arrays_.add<8>("Int64", "offsets", 1, triangles_,
                                [](std::uint64_t i, auto& record) { record.append(3 * (i + 1)); });
}

}  // namespace

Result<void> write_vtp(const PaintedMesh& painted, WholeFile& file) { return VtpFile(painted).write(file); }

}  // namespace cdfr
