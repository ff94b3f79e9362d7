/// What a field is made of, in numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/field/field.h"
#include "field/field_data.h"

namespace cdfr {

/// Slots of the triangles in a leaf's list, in list order.
std::vector<std::uint32_t> slots_of(const FieldData& field, const Block& block, const LeafRecord& leaf);

/// Of the field with all that it holds.
std::uint64_t total_bytes(const FieldData& field) noexcept;
Stats stats_of(const FieldData& field);

/// XXH64 over key, side and list of each leaf in Morton order, and over the order of triangles that entries
/// refer to.
std::uint64_t checksum_of(const FieldData& field);

}  // namespace cdfr
