#include "mesh/examine.h"

#include <utility>

#include "mesh/counts.h"
#include "mesh/mesh_fault.h"
#include "mesh/self_contact.h"
#include "mesh/shells.h"

namespace cdfr {
Result<Examined> examine(MeshView mesh, Progress& progress) {
  if (auto fault = mesh_fault(mesh)) return std::move(*fault);
  Examined e;
  e.topology = weld_topology(mesh);
  if (!progress.poll()) return Progress::error();
  const std::vector<std::uint32_t> twins = first_twins(e.topology);
  e.report = counted(mesh, e.topology, twins);
  if (!progress.poll()) return Progress::error();
  BvhAndOrder tree = build_bvh(mesh);
  e.bvh = std::move(tree.bvh);
  if (!progress.poll()) return Progress::error();
  e.triangles = gather_triangles(mesh, e.topology, tree.order);
  const std::vector<std::uint8_t> touching = self_contacts(e.space(), progress);
  if (progress.cancelled()) return Progress::error();
  for (const std::uint8_t touches : touching) e.report.touching_triangles += touches;
  find_shells(e, twins, touching);
  return e;
}

}  // namespace cdfr
