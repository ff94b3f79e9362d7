#include <cmath>
#include <string>

#include "cdfr/export/painted.h"
#include "core/whole_file.h"
#include "export/extension.h"
#include "export/mesh_formats.h"
#include "export/paint.h"
#include "export/painted_formats.h"
#include "export/writable_mesh.h"

namespace cdfr {
namespace {

/// Counts before contents: what is far too large is refused without being read.
Result<void> check(const PaintedMesh& painted, const std::string& format) {
  if (auto checked = check_painted(painted); !checked) return checked;
  if (format == ".glb") {
    if (auto checked = check_glb_size(painted); !checked) return checked;
  }
  return check_writable(painted.mesh);
}

}  // namespace

Result<void> write_painted(const PaintedMesh& painted, const std::filesystem::path& path,
                           double metres_per_unit) {
  const std::string format = format_of(path);
  if (format != ".ply" && format != ".vtp" && format != ".glb") {
    return Error{Code::bad_option, 0,
                 "a painted mesh is written as .ply, .vtp or .glb, not as '" + format + "'"};
  }
  if (!std::isfinite(metres_per_unit) || metres_per_unit <= 0) {
    return Error{Code::bad_option, 0, "metres a unit must be finite and positive"};
  }
  if (auto checked = check(painted, format); !checked) return checked;
  auto file = WholeFile::create(path);
  if (!file) return file.error();
  const auto written = format == ".ply"   ? write_ply(painted, *file)
                       : format == ".vtp" ? write_vtp(painted, *file)
                                          : write_glb(painted, metres_per_unit, *file);
  if (!written) return written;
  return file->finish();
}

}  // namespace cdfr
