/// Do two cores join? Looked at closer, where they may.
///
/// Cells in doubt where the territories of different cores meet are halved, then what of them still is, until
/// the cores are joined for certain, or nothing links them, or the cells are 2^-8 of e or too many. Each
/// round keeps what the cells' joins say of components: the octants of a cell hold all of it that is deeper
/// than T, and the core point of a cell stays tied to the octant that it lies in.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/cell_index.h"
#include "analysis/cell_joins.h"
#include "analysis/heavy_cell.h"
#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

/// Two cores of which it stays open whether they are one.
struct OpenNeck {
  std::uint32_t first, second;  ///< roots in CellJoins::cores
  Vec3 place;
};

struct NeckFindings {
  std::vector<OpenNeck> open;  ///< each pair once
  std::uint64_t looks = 0;
};

/// Joins cores in `joins`; its doubts stay as they are.
NeckFindings look_at_necks(const FieldData& field, const Threshold& threshold,
                           std::span<const HeavyCell> cells, const CellIndex& index, CellJoins& joins,
                           Progress& progress);

}  // namespace cdfr
