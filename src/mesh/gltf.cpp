// glTF 2.0 and GLB: the triangles of the scene, in scene order, in world coordinates.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/coordinate.h"
#include "mesh/gltf_accessor.h"
#include "mesh/gltf_document.h"
#include "mesh/gltf_scene.h"
#include "mesh/readers.h"
#include "mesh/text.h"

namespace cdfr {
namespace {

enum Mode : std::uint64_t { mode_triangles = 4, mode_strip = 5, mode_fan = 6 };

/// Extensions that change how a surface looks and not where it is.
constexpr std::array harmless_extensions = {"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_",
                                            "KHR_mesh_quantization"};

struct Primitive {
  std::size_t positions = 0;  ///< into the plan's list
  std::optional<GltfAccessor> indices;
  std::uint64_t mode = mode_triangles;
  std::uint64_t triangles = 0;
  std::uint32_t patch = 0;
};

/// A mesh ready to be placed, any number of times. Primitives that share positions share vertices.
struct MeshPlan {
  std::vector<GltfAccessor> positions;
  std::vector<Primitive> primitives;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
};

class Gltf {
 public:
  explicit Gltf(std::span<const std::byte> bytes) : document_(open_gltf(bytes)), file_size_(bytes.size()) {
    check_extensions();
    materials_ = static_cast<std::uint32_t>(
        std::min<std::size_t>(array_member(document_.root, "materials", {"top", 0}).size(), no_index - 1));
    plans_.resize(array_member(document_.root, "meshes", {"top", 0}).size());
  }

  Mesh read() {
    const auto instances = gltf_instances(document_.root);
    reserve(instances);
    for (const auto& instance : instances) place(plan(instance.mesh), instance);
    name_patches();
    return std::move(mesh_);
  }

 private:
  void check_extensions() const {
    const Json& required = array_member(document_.root, "extensionsRequired", {"top", 0});
    for (std::uint64_t i = 0; i < required.size(); ++i) {
      const auto name = required[i].is_string() ? required[i].get<std::string>() : std::string();
      const auto begins_name = [&](const char* prefix) { return name.starts_with(prefix); };
      if (std::none_of(harmless_extensions.begin(), harmless_extensions.end(), begins_name)) {
        refuse(Code::file_format, {"extensionsRequired", i},
               "extension " + in_quotes(name) + " is not supported");
      }
    }
  }

  /// A few nodes can ask for a small mesh without end. So the whole is counted before anything is made: it
  /// may be as much as a file of this size could hold without repetition, and 2^24 in any case.
  void reserve(const std::vector<GltfInstance>& instances) {
    const std::uint64_t most =
        std::min<std::uint64_t>(std::max<std::uint64_t>(file_size_, 1U << 24), no_index - 1);
    std::uint64_t vertices = 0, triangles = 0;
    for (const auto& instance : instances) {
      vertices += plan(instance.mesh).vertices;
      triangles += plan(instance.mesh).triangles;
      if (vertices > most || triangles > most) {
        refuse(Code::out_of_range, {"mesh", instance.mesh},
               "the scene repeats it to more than " + std::to_string(most) + " vertices or triangles");
      }
    }
    mesh_.vertices.reserve(vertices);
    mesh_.triangles.reserve(triangles);
  }

  const MeshPlan& plan(std::uint64_t index) {
    const GltfPlace place{"mesh", index};
    const Json& mesh = gltf_object(document_.root, "meshes", place);
    if (!plans_[index]) plans_[index] = make_plan(mesh, place);
    return *plans_[index];
  }

  MeshPlan make_plan(const Json& mesh, const GltfPlace& place) const {
    for (const Json& weight : array_member(mesh, "weights", place)) {
      if (weight != 0) refuse(Code::file_format, place, "morphed meshes are not supported");
    }
    MeshPlan plan;
    std::map<std::uint64_t, std::size_t> slots;
    for (const Json& primitive : array_member(mesh, "primitives", place)) {
      if (!primitive.is_object()) refuse(Code::file_format, place, "primitive is no object");
      const std::uint64_t mode = unsigned_member(primitive, "mode", place, mode_triangles);
      if (mode > mode_fan)
        refuse(Code::file_format, place, "primitive mode " + std::to_string(mode) + " is not known");
      if (mode >= mode_triangles) add_primitive(primitive, place, mode, slots, plan);
    }
    return plan;
  }

  void add_primitive(const Json& primitive, const GltfPlace& place, std::uint64_t mode,
                     std::map<std::uint64_t, std::size_t>& slots, MeshPlan& plan) const {
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object()) {
      refuse(Code::file_format, place, "primitive has no attributes");
    }
    const std::uint64_t accessor = unsigned_member(*attributes, "POSITION", place);
    const auto [slot, is_new] = slots.try_emplace(accessor, plan.positions.size());
    if (is_new) {
      plan.positions.push_back(GltfAccessor::positions(document_, accessor));
      plan.vertices += plan.positions.back().count();
    }
    Primitive made;
    made.positions = slot->second;
    made.mode = mode;
    if (primitive.contains("indices")) {
      made.indices = GltfAccessor::indices(document_, unsigned_member(primitive, "indices", place));
    }
    const std::uint64_t corners =
        made.indices ? made.indices->count() : plan.positions[made.positions].count();
    if (mode == mode_triangles && corners % 3 != 0) {
      refuse(Code::file_format, place, std::to_string(corners) + " corners do not make whole triangles");
    }
    made.triangles = mode == mode_triangles ? corners / 3 : corners < 3 ? 0 : corners - 2;
    made.patch = patch_of(primitive, place);
    plan.triangles += made.triangles;
    if (made.triangles > 0) plan.primitives.push_back(std::move(made));
  }

  /// The material's number, or one past the last for a primitive without.
  std::uint32_t patch_of(const Json& primitive, const GltfPlace& place) const {
    const std::uint64_t material = unsigned_member(primitive, "material", place, materials_);
    if (material >= materials_ && primitive.contains("material"))
      refuse(Code::bad_index, place, "material is not there");
    return static_cast<std::uint32_t>(material);
  }

  void place(const MeshPlan& plan, const GltfInstance& instance) {
    std::vector<std::uint32_t> bases;
    for (const auto& positions : plan.positions) {
      bases.push_back(static_cast<std::uint32_t>(mesh_.vertices.size()));
      for (std::uint64_t i = 0; i < positions.count(); ++i)
        place_vertex(instance.world.apply(positions.position(i)));
    }
    for (const auto& primitive : plan.primitives) {
      const std::uint64_t count = plan.positions[primitive.positions].count();
      place_triangles(primitive, bases[primitive.positions], count, instance.mirrored);
    }
  }

  void place_vertex(const Vec3& position) {
    if (const auto wrong = coordinate_fault(position)) {
      refuse(*wrong, {"vertex", mesh_.vertices.size()}, coordinate_fault_text(*wrong));
    }
    mesh_.vertices.push_back(position);
  }

  void place_triangles(const Primitive& primitive, std::uint32_t base, std::uint64_t vertices,
                       bool mirrored) {
    for (std::uint64_t t = 0; t < primitive.triangles; ++t) {
      Triangle triangle{};
      const auto corners = corners_of(primitive.mode, t);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint64_t corner = primitive.indices ? primitive.indices->index(corners[k]) : corners[k];
        if (corner >= vertices) {
          refuse(Code::bad_index, {"triangle", mesh_.triangles.size()},
                 "index " + std::to_string(corner) + " is out of range, vertices are " +
                     std::to_string(vertices));
        }
        triangle[k] = base + static_cast<std::uint32_t>(corner);
      }
      if (mirrored) std::swap(triangle[1], triangle[2]);
      mesh_.triangles.push_back(triangle);
      if (materials_ > 0) mesh_.patches.push_back(primitive.patch);
    }
  }

  /// Which of the primitive's corners make its triangle t, by the standard (3.7.2.1).
  static std::array<std::uint64_t, 3> corners_of(std::uint64_t mode, std::uint64_t t) noexcept {
    if (mode == mode_strip) return {t, t + 1 + t % 2, t + 2 - t % 2};
    if (mode == mode_fan) return {t + 1, t + 2, 0};
    return {3 * t, 3 * t + 1, 3 * t + 2};
  }

  void name_patches() {
    for (std::uint64_t i = 0; i < materials_; ++i) {
      const Json& material = gltf_object(document_.root, "materials", {"material", i});
      const auto name = material.find("name");
      mesh_.patch_names.push_back(name != material.end() && name->is_string() ? name->get<std::string>()
                                                                              : "");
    }
    const auto& patches = mesh_.patches;
    if (std::find(patches.begin(), patches.end(), materials_) != patches.end())
      mesh_.patch_names.emplace_back();
  }

  GltfDocument document_;
  std::uint64_t file_size_;
  std::uint32_t materials_ = 0;
  std::vector<std::optional<MeshPlan>> plans_;
  Mesh mesh_;
};

}  // namespace

Result<Mesh> read_gltf(std::span<const std::byte> bytes) {
  try {
    return Gltf(bytes).read();
  } catch (const Failure& failure) {
    return failure.error();
  }
}

}  // namespace cdfr
