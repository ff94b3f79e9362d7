#include "mesh/examine.h"

#include <utility>

#include "mesh/counts.h"
#include "mesh/mesh_fault.h"
#include "mesh/self_contact.h"
#include "mesh/shells.h"

namespace cdfr {
Result<Examined> examine(MeshView mesh, Progress& progress, const Scratch* scratch) {
  if (auto fault = mesh_fault(mesh)) return std::move(*fault);
  Examined e(scratch);
  e.topology = weld_topology(mesh, scratch);
  if (!progress.poll()) return Progress::error();
  const Large<std::uint32_t> twins = first_twins(e.topology, scratch);
  e.report = counted(mesh, e.topology, twins, scratch);
  if (!progress.poll()) return Progress::error();
  BvhAndOrder tree = build_bvh(mesh, scratch);
  e.bvh = std::move(tree.bvh);
  if (!progress.poll()) return Progress::error();
  e.triangles = gather_triangles(mesh, e.topology, tree.order, scratch);
  const Large<std::uint8_t> touching = self_contacts(e.space(), progress, scratch);
  if (progress.cancelled()) return Progress::error();
  for (const std::uint8_t touches : touching) e.report.touching_triangles += touches;
  find_shells(e, twins, touching, scratch);
  return e;
}

}  // namespace cdfr
