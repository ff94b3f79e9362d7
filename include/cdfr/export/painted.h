/// A mesh with numbers on its vertices or triangles, one of them shown as colour, and balls and words beside
/// it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/types.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

enum class ArrayPlace : std::uint8_t { vertex, face };

/// One number for each vertex or each triangle; NaN where there is none. Borrowed.
struct MeshArray {
  /// A letter or underscore, then letters, digits and underscores, at most 63 in all; no two alike, and none
  /// that a format needs itself (x, y, z, red, green, blue, alpha, patch, colour, radius, label,
  /// vertex_indices).
  std::string name;
  ArrayPlace place = ArrayPlace::vertex;
  std::span<const double> values;
};

/// In the mesh's unit.
struct PaintedBall {
  Vec3 centre;
  double radius = 0;  ///< finite, above 0
};

/// Text that belongs to a place: "1: 17.0 mm +- 0.1". Printable ASCII is drawn; anything else as an empty
/// box.
struct PaintedLabel {
  Vec3 place;
  std::string text;
};

/// What write_painted takes. Everything but the mesh may be left out.
struct PaintedMesh {
  MeshView mesh;
  std::vector<MeshArray> arrays{};
  std::string painted{};           ///< name of the array that is shown as colour; empty: the part is grey
  double least = 0, greatest = 1;  ///< values of the first and the last colour; finite, least <= greatest
  std::string unit{};              ///< a label, for the legend
  bool translucent = false;        ///< the part is drawn half transparent, so that balls in it are seen
  std::vector<PaintedBall> balls{};
  std::vector<PaintedLabel> labels{};
  std::vector<std::string> notes{};  ///< lines about where all this comes from
};

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue as sRGB

/// The ramp: warm yellow at `least` (thin), over orange, red and violet to dark blue at `greatest` (thick).
/// It darkens all the way, so its order is seen in grey and by the colour-blind. Values beyond the range have
/// the colours of its ends, NaN is light grey. A range of one value has the middle colour there.
CDFR_API Colour painted_colour(double value, double least, double greatest) noexcept;

/// Writes it; the extension names the format.
/// - .ply, binary little endian: the arrays as double properties of their names, red green blue uchar on the
///   element of the painted one. No balls, no labels; range and notes as comments.
/// - .vtp, for ParaView: the arrays as doubles, the colours as `colour`. Balls and labels are further points
///   with a vertex cell each, told by the arrays `radius` (NaN elsewhere) and `label`. Range, unit and notes
///   as field data.
/// - .glb, float32, for looking: vertex colours; the painted value as attribute _VALUE, where NaN is the
///   lowest float; a legend; balls half transparent; labels as thin strokes beside the part, with a line to
///   their place. In metres by `metres_per_unit`.
/// Patches are kept in .ply and .vtp. Written to a temporary file, synced, renamed; the same bytes on every
/// machine. Control characters in texts become blanks.
/// Errors: bad_option (extension, arrays, range, balls, metres_per_unit), bad_index, not_finite,
/// out_of_range, file_write (also a GLB beyond 4 GiB). O(vertices + triangles); thread safe.
CDFR_API Result<void> write_painted(const PaintedMesh& painted, const std::filesystem::path& path,
                                    double metres_per_unit = 1);

}  // namespace cdfr
