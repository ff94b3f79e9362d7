/// Samples of wall thickness as a table: CSV, NPY or PLY.
#pragma once

#include <span>
#include <string>

#include "byte_sink.h"
#include "cdfr/analysis/thickness.h"

namespace cdfr::command {

/// ".csv": x,y,z,nx,ny,nz,thickness,error,ox,oy,oz,triangle,opposite,patch,opposite_patch,area,at_edge,facet,
/// opposed with a header line, digits that read back the same bits. ".npy": (n,19) little endian doubles, the
/// same columns. ".ply": binary little endian vertices with those properties, double but for the four numbers
/// (uint), at_edge and opposed (uchar). Where nothing was met thickness, error and opposite point are NaN,
/// and opposite is -1 (PLY: 4294967295).
void write_thickness_table(ByteSink& sink, std::span<const ThicknessSample> samples,
                           const std::string& extension);

}  // namespace cdfr::command
