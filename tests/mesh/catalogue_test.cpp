// The audit of every public mesh against the counts that another program found in it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "cdfr/mesh/audit.h"
#include "cdfr/mesh/read.h"

namespace cdfr {
namespace {

const std::filesystem::path folder = std::filesystem::path(CDFR_SHARED_DATA) / "public";

using Row = std::map<std::string, std::string>;

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
  return fields;
}

std::vector<Row> mesh_rows() {
  std::ifstream file(folder / "CATALOGUE.tsv");
  std::string line;
  std::getline(file, line);
  const auto names = fields_of(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const auto fields = fields_of(line);
    Row row;
    for (std::size_t i = 0; i < names.size() && i < fields.size(); ++i) row[names[i]] = fields[i];
    const std::string format = row["format"].substr(0, 3);
    const bool packed = row["file"].ends_with(".gz");
    if ((format == "STL" || format == "OBJ" || format == "PLY" || format == "GLB") && !packed)
      rows.push_back(row);
  }
  return rows;
}

std::filesystem::path path_of(const Row& row) {
  const std::string long_name = "open-dynamic-robot-initiative_open_robot_actuator_hardware";
  std::string file = row.at("file");
  if (file.starts_with(long_name)) file.replace(0, long_name.size(), "odri");
  return folder / file;
}

/// What the catalogue's own reader mended in silence and this one refuses.
const std::map<std::string, Code> refused = {{"dirty_pub/nist1_ascii_truncated.stl", Code::file_truncated},
                                             {"dirty_pub/nist1_bad_indices.obj", Code::bad_index},
                                             {"dirty_pub/nist1_comma_decimal_crlf.obj", Code::file_format},
                                             {"dirty_pub/nist1_count_0xFFFFFFFF.stl", Code::file_truncated},
                                             {"dirty_pub/nist1_count_too_big.stl", Code::file_truncated},
                                             {"dirty_pub/nist1_count_too_small.stl", Code::file_format},
                                             {"dirty_pub/nist1_nan_inf.stl", Code::not_finite},
                                             {"dirty_pub/nist1_truncated.stl", Code::file_truncated}};

/// wallhole: the catalogue's reader lost the lines that go on after a backslash; read whole, the part is
/// closed.
const std::string misread = "mikedh_trimesh/wallhole.obj";
/// car: two nodes are mirrored, and the catalogue's reader left their volumes negative.
const std::string mirrored = "kovacsv_Online3DViewer/car.glb";

std::uint64_t number(const Row& row, const std::string& name) {
  return std::strtoull(row.at(name).c_str(), nullptr, 10);
}

/// The catalogue counts triangles with two equal corners, and says in its notes how many more are collinear.
std::uint64_t zero_area(const Row& row) {
  const std::string& notes = row.count("notes") != 0 ? row.at("notes") : "";
  const auto at = notes.find(" zero-area");
  std::uint64_t more = 0;
  if (at != std::string::npos)
    more = std::strtoull(notes.c_str() + notes.find_last_of(";\t", at) + 1, nullptr, 10);
  return number(row, "degenerate_tris") + more;
}

void expect_counts(const Row& row, const MeshReport& report) {
  EXPECT_EQ(report.triangles, number(row, "triangles"));
  EXPECT_EQ(report.vertices, number(row, "vertices_exact_weld"));
  EXPECT_EQ(report.open_edges, number(row, "boundary_edges"));
  EXPECT_EQ(report.nonmanifold_edges, number(row, "nonmanifold_edges"));
  EXPECT_EQ(report.flipped_edges, number(row, "misoriented_edges"));
  EXPECT_EQ(report.degenerate_triangles, zero_area(row));
  EXPECT_EQ(report.duplicate_triangles, number(row, "duplicate_tris"));
  // The catalogue joins components through vertices, this one through edges.
  EXPECT_GE(report.components, number(row, "components"));
  if (report.nonmanifold_vertices == 0) {
    EXPECT_EQ(report.components, number(row, "components"));
  }
  const bool watertight = row.at("status") == "watertight-manifold";
  EXPECT_EQ(report.closed(), watertight);
  if (!watertight || row.at("file") == mirrored) return;
  const double volume = std::strtod(row.at("signed_volume").c_str(), nullptr);
  EXPECT_LE(std::fabs(report.volume - volume), 5e-6 * std::fabs(volume)) << report.volume;
}

TEST(Catalogue, AuditAgrees) {
  if (!std::filesystem::exists(folder / "CATALOGUE.tsv")) GTEST_SKIP() << "no shared data at " << folder;
  const auto rows = mesh_rows();
  EXPECT_GT(rows.size(), 60U);
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at("file"));
    const auto mesh = read_mesh(path_of(row));
    if (const auto entry = refused.find(row.at("file")); entry != refused.end()) {
      ASSERT_FALSE(mesh);
      EXPECT_EQ(mesh.error().code, entry->second) << mesh.error().text;
      continue;
    }
    ASSERT_TRUE(mesh) << mesh.error().text;
    const auto report = audit(mesh->view());
    if (number(row, "triangles") == 0) {
      EXPECT_EQ(report.error().code, Code::empty_mesh);
    } else if (row.at("file") == misread) {
      EXPECT_EQ(report.value().triangles, 66U);
      EXPECT_EQ(report.value().open_edges, 0U);
    } else {
      expect_counts(row, report.value());
    }
  }
}

TEST(Catalogue, MirroredPartsOfTheCarStayOutward) {
  const auto path = folder / mirrored;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data at " << path;
  const Mesh mesh = read_mesh(path).value();
  ASSERT_EQ(mesh.patch_names.size(), 9U);
  for (const std::uint32_t patch : {2U, 3U}) {  // the front and back lights
    Mesh part;
    part.vertices = mesh.vertices;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.patches[t] == patch) part.triangles.push_back(mesh.triangles[t]);
    }
    const auto report = audit(part.view()).value();
    EXPECT_TRUE(report.closed()) << mesh.patch_names[patch];
    EXPECT_GT(report.volume, 0) << mesh.patch_names[patch];
  }
}

}  // namespace
}  // namespace cdfr
