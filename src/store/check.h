/// Is what a file says a field at all? Every index, range and tree is checked, so that no query can leave its
/// arrays.
#pragma once

#include "cdfr/core/result.h"
#include "field/field_data.h"

namespace cdfr {

/// Code::file_format with what is wrong and where (an element of an array). O(size).
Result<void> check_field(const FieldData& field);

}  // namespace cdfr
