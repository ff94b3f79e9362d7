// PLY: the x, y, z of element vertex, and the polygons of element face; everything else is stepped over.
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "mesh/coordinate.h"
#include "mesh/ply_body.h"
#include "mesh/ply_header.h"
#include "mesh/readers.h"

namespace cdfr {
namespace {

bool is_corner_list(const PlyProperty& property) noexcept {
  return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

template <class Body>
class PlyReader {
 public:
  /// Precondition: the header has passed check_elements.
  PlyReader(std::span<const std::byte> bytes, const PlyHeader& header)
      : header_(header),
        body_(bytes, header),
        vertex_count_(static_cast<double>(header.find("vertex")->count)) {}

  Result<Mesh> read() {
    for (const auto& element : header_.elements) {
      if (auto done = read_element(element); !done) return done.error();
    }
    if (!body_.at_end())
      return body_.fault(Code::file_format, "there is more after the last element of the PLY");
    return std::move(mesh_);
  }

 private:
  Result<void> read_element(const PlyElement& element) {
    if (element.count > body_.most_rows(element)) {
      return body_.fault(Code::file_truncated, "PLY counts " + std::to_string(element.count) +
                                                   " of element " + in_quotes(element.name) +
                                                   ", more than the file can hold");
    }
    if (element.name == "vertex") mesh_.vertices.reserve(element.count);
    if (element.name == "face") mesh_.triangles.reserve(element.count);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      const bool started = body_.start_row();
      auto done = !started                   ? cut(element, row)
                  : element.name == "vertex" ? read_vertex(element, row)
                  : element.name == "face"   ? read_face(element, row)
                                             : skip_row(element, row);
      if (!done) return done;
      if (!body_.end_row()) return cut(element, row);
    }
    return {};
  }

  Result<void> read_vertex(const PlyElement& element, std::uint64_t row) {
    Vec3 position;
    for (const auto& property : element.properties) {
      double* x = nullptr;
      if (property.name == "x") x = &position.x;
      if (property.name == "y") x = &position.y;
      if (property.name == "z") x = &position.z;
      const bool good = x != nullptr ? body_.coordinate(property.type, *x) : skip(property);
      if (!good) return cut(element, row);
    }
    if (const auto wrong = coordinate_fault(position)) {
      return Error{*wrong, row, "vertex " + std::to_string(row) + " " + coordinate_fault_text(*wrong)};
    }
    mesh_.vertices.push_back(position);
    return {};
  }

  Result<void> read_face(const PlyElement& element, std::uint64_t row) {
    for (const auto& property : element.properties) {
      if (is_corner_list(property)) {
        if (auto done = read_polygon(element, property, row); !done) return done;
      } else if (!skip(property)) {
        return cut(element, row);
      }
    }
    return {};
  }

  Result<void> read_polygon(const PlyElement& element, const PlyProperty& list, std::uint64_t row) {
    double count = 0;
    if (!body_.number(*list.count_type, count)) return cut(element, row);
    if (count < 0)
      return body_.fault(Code::file_format, "face " + std::to_string(row) + " has a negative count");
    const auto corners = static_cast<std::uint64_t>(count);
    std::uint32_t first = 0, previous = 0;
    for (std::uint64_t i = 0; i < corners; ++i) {
      double index = 0;
      if (!body_.number(list.type, index)) return cut(element, row);
      if (!(index >= 0 && index < vertex_count_)) return bad_index(row, index);
      const auto corner = static_cast<std::uint32_t>(index);
      if (i == 0) first = corner;
      if (i >= 2) {
        if (mesh_.triangles.size() >= no_index - 1)
          return body_.fault(Code::out_of_range, "more than 2^32 - 2 triangles");
        mesh_.triangles.push_back({first, previous, corner});
      }
      previous = corner;
    }
    return {};
  }

  Result<void> skip_row(const PlyElement& element, std::uint64_t row) {
    for (const auto& property : element.properties) {
      if (!skip(property)) return cut(element, row);
    }
    return {};
  }

  bool skip(const PlyProperty& property) noexcept {
    if (!property.count_type) return body_.skip(property.type, 1);
    double count = 0;
    return body_.number(*property.count_type, count) && count >= 0 &&
           body_.skip(property.type, static_cast<std::uint64_t>(count));
  }

  Error bad_index(std::uint64_t row, double index) const {
    return body_.fault(Code::bad_index, "face " + std::to_string(row) + " has index " +
                                            std::to_string(static_cast<std::int64_t>(index)) +
                                            ", vertices are " +
                                            std::to_string(static_cast<std::uint64_t>(vertex_count_)));
  }
  Error cut(const PlyElement& element, std::uint64_t row) const {
    return body_.error(in_quotes(element.name) + " " + std::to_string(row));
  }

  const PlyHeader& header_;
  Body body_;
  double vertex_count_;
  Mesh mesh_;
};

Result<void> check_elements(const PlyHeader& header) {
  const auto fault = [](Code code, std::string text) {
    return Error{code, 0, "PLY header: " + std::move(text)};
  };
  const PlyElement* vertices = header.find("vertex");
  if (vertices == nullptr) return fault(Code::file_format, "no element vertex");
  if (vertices->count >= no_index) return fault(Code::out_of_range, "more than 2^32 - 2 vertices");
  for (const char* name : {"x", "y", "z"}) {
    const auto is_it = [&](const PlyProperty& property) {
      return property.name == name && !property.count_type;
    };
    if (std::none_of(vertices->properties.begin(), vertices->properties.end(), is_it)) {
      return fault(Code::file_format, std::string("element vertex has no property ") + name);
    }
  }
  if (header.find("tristrips") != nullptr)
    return fault(Code::file_format, "triangle strips are not supported");
  const PlyElement* faces = header.find("face");
  if (faces == nullptr || faces->count == 0) return {};
  const auto& properties = faces->properties;
  const auto lists = std::count_if(properties.begin(), properties.end(), is_corner_list);
  if (lists != 1)
    return fault(Code::file_format, "element face needs one list vertex_indices or vertex_index");
  const auto list = std::find_if(properties.begin(), properties.end(), is_corner_list);
  if (list->type == PlyType::float32 || list->type == PlyType::float64) {
    return fault(Code::file_format, "the vertex indices are no integers");
  }
  return {};
}

}  // namespace

Result<Mesh> read_ply(std::span<const std::byte> bytes) {
  const auto header = read_ply_header(bytes);
  if (!header) return header.error();
  if (auto good = check_elements(*header); !good) return good.error();
  if (header->format == PlyFormat::ascii) return PlyReader<PlyAscii>(bytes, *header).read();
  return PlyReader<PlyBinary>(bytes, *header).read();
}

}  // namespace cdfr
