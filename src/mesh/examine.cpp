#include "mesh/examine.h"

#include <optional>
#include <string>
#include <utility>

#include "mesh/coordinate.h"
#include "mesh/counts.h"
#include "mesh/self_contact.h"
#include "mesh/shells.h"

namespace cdfr {
namespace {

std::optional<Error> fault_of(const MeshView& mesh) {
  if (mesh.triangles.empty()) return Error{Code::empty_mesh, 0, "mesh has no triangles"};
  if (mesh.triangles.size() >= no_index || mesh.vertices.size() >= no_index) {
    return Error{Code::out_of_range, 0, "mesh has more than 2^32 - 2 triangles or vertices"};
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t corner : mesh.triangles[t]) {
      if (corner < mesh.vertices.size()) continue;
      return Error{Code::bad_index, t,
                   "triangle " + std::to_string(t) + " has index " + std::to_string(corner) +
                       ", vertices are " + std::to_string(mesh.vertices.size())};
    }
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const auto wrong = coordinate_fault(mesh.vertices[i]);
    if (wrong) return Error{*wrong, i, "vertex " + std::to_string(i) + " " + coordinate_fault_text(*wrong)};
  }
  return std::nullopt;
}

}  // namespace

Result<Examined> examine(MeshView mesh, Progress& progress) {
  if (auto fault = fault_of(mesh)) return std::move(*fault);
  Examined e;
  e.topology = weld_topology(mesh);
  if (!progress.poll()) return Progress::error();
  e.report = counted(mesh, e.topology);
  if (!progress.poll()) return Progress::error();
  BvhAndOrder tree = build_bvh(mesh);
  e.bvh = std::move(tree.bvh);
  if (!progress.poll()) return Progress::error();
  e.triangles = gather_triangles(mesh, e.topology, tree.order);
  const std::vector<std::uint8_t> touching = self_contacts(e.space(), progress);
  if (progress.cancelled()) return Progress::error();
  for (const std::uint8_t touches : touching) e.report.touching_triangles += touches;
  find_shells(e, touching);
  return e;
}

}  // namespace cdfr
