/// Elements of a glTF accessor, after every number that says where they are was checked against the bytes
/// there are.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cdfr/core/types.h"
#include "mesh/gltf_document.h"

namespace cdfr {

class GltfAccessor {
 public:
  /// Positions: VEC3 of float, or of 8 or 16 bit integers (KHR_mesh_quantization).
  static GltfAccessor positions(const GltfDocument& document, std::uint64_t index);
  /// Indices: SCALAR of 8, 16 or 32 bits, unsigned.
  static GltfAccessor indices(const GltfDocument& document, std::uint64_t index);

  std::uint64_t count() const noexcept { return count_; }
  /// Precondition: i < count(), and the accessor was made by positions().
  Vec3 position(std::uint64_t i) const noexcept;
  /// Precondition: i < count(), and the accessor was made by indices().
  std::uint32_t index(std::uint64_t i) const noexcept;

 private:
  GltfAccessor(const GltfDocument& document, std::uint64_t index, std::string_view type,
               std::uint64_t components);
  double component(const std::byte* at) const noexcept;

  const std::byte* data_ = nullptr;
  std::uint64_t count_ = 0;
  std::uint64_t stride_ = 0;
  std::uint64_t component_type_ = 0;
  bool normalized_ = false;
};

}  // namespace cdfr
