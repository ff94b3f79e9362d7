#include "cdfr/store/store.h"
#include "field/field_data.h"
#include "store/arrays.h"
#include "store/write_field.h"

namespace cdfr {

Result<void> save(const Field& field, const std::filesystem::path& path, const std::string& unit,
                  Packing packing, const Run& run) {
  Progress progress(run);
  const FieldData& data = field.data();
  return write_field(arrays_of(data, unit), data.map.get(), path, packing, progress);
}

}  // namespace cdfr
