#include "mesh/gltf_scene.h"

#include <string>
#include <utility>

namespace cdfr {
namespace {

struct Placed {
  Affine transform;
  bool mirrored = false;
};

Affine product(const Affine& a, const Affine& b) noexcept {
  Affine result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto& row = a.rows[i];
      result.rows[i][j] = row[0] * b.rows[0][j] + row[1] * b.rows[1][j] + row[2] * b.rows[2][j];
    }
    result.rows[i][3] += a.rows[i][3];
  }
  return result;
}

double determinant(const Affine& a) noexcept {
  const auto& [r, s, t] = a.rows;
  return r[0] * (s[1] * t[2] - s[2] * t[1]) - r[1] * (s[0] * t[2] - s[2] * t[0]) +
         r[2] * (s[0] * t[1] - s[1] * t[0]);
}

Placed from_matrix(const std::array<double, 16>& column_major, const GltfPlace& place) {
  Placed placed;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) placed.transform.rows[i][j] = column_major[4 * j + i];
  }
  if (column_major[3] != 0 || column_major[7] != 0 || column_major[11] != 0 || column_major[15] != 1) {
    refuse(Code::file_format, place, "matrix is not affine");
  }
  placed.mirrored = determinant(placed.transform) < 0;
  return placed;
}

Placed from_parts(const Json& node, const GltfPlace& place) {
  std::array<double, 3> move{}, scale{1, 1, 1};
  std::array<double, 4> turn{0, 0, 0, 1};
  numbers_member(node, "translation", place, move);
  numbers_member(node, "rotation", place, turn);
  numbers_member(node, "scale", place, scale);
  const auto [x, y, z, w] = turn;
  const double norm = x * x + y * y + z * z + w * w;
  if (!(norm > 0.5 && norm < 2)) refuse(Code::file_format, place, "rotation is no unit quaternion");
  // Dividing by the norm makes the rotation a rotation even though files round the quaternion to floats.
  const double s = 2 / norm;
  const std::array<std::array<double, 3>, 3> rotation = {
      {{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
       {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)},
       {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}}};
  Placed placed;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) placed.transform.rows[i][j] = rotation[i][j] * scale[j];
    placed.transform.rows[i][3] = move[i];
  }
  placed.mirrored = ((scale[0] < 0) != (scale[1] < 0)) != (scale[2] < 0);
  return placed;
}

Placed local_transform(const Json& node, const GltfPlace& place) {
  std::array<double, 16> matrix{};
  if (numbers_member(node, "matrix", place, matrix)) return from_matrix(matrix, place);
  return from_parts(node, place);
}

void check_supported(const Json& node, const GltfPlace& place) {
  if (node.contains("skin")) refuse(Code::file_format, place, "skinned meshes are not supported");
  const auto extensions = node.find("extensions");
  if (extensions != node.end() && extensions->is_object() &&
      extensions->contains("EXT_mesh_gpu_instancing")) {
    refuse(Code::file_format, place, "EXT_mesh_gpu_instancing is not supported");
  }
}

class Walk {
 public:
  explicit Walk(const Json& root)
      : root_(root), reached_(array_member(root, "nodes", {"top", 0}).size(), false) {}

  std::vector<GltfInstance> from(const Json& scene, const GltfPlace& place) {
    push(array_member(scene, "nodes", place), place, {});
    while (!waiting_.empty()) {
      const auto [index, parent] = std::move(waiting_.back());
      waiting_.pop_back();
      visit({"node", index}, parent);
    }
    return std::move(instances_);
  }

 private:
  struct Waiting {
    std::uint64_t index = 0;
    Placed parent;
  };

  void visit(const GltfPlace& place, const Placed& parent) {
    const Json& node = gltf_object(root_, "nodes", place);
    check_supported(node, place);
    Placed placed = local_transform(node, place);
    placed.transform = product(parent.transform, placed.transform);
    placed.mirrored = placed.mirrored != parent.mirrored;
    if (node.contains("mesh")) {
      instances_.push_back({unsigned_member(node, "mesh", place), placed.transform, placed.mirrored});
    }
    push(array_member(node, "children", place), place, placed);
  }

  /// Last child first, so that the first is on top of the stack.
  void push(const Json& nodes, const GltfPlace& place, const Placed& parent) {
    for (auto item = nodes.rbegin(); item != nodes.rend(); ++item) {
      if (!item->is_number_unsigned()) refuse(Code::file_format, place, "names a node that is no number");
      const GltfPlace node{"node", item->get<std::uint64_t>()};
      gltf_object(root_, "nodes", node);
      // Here and not when visited: a list that names one node a million times must not fill memory.
      if (reached_[node.index]) refuse(Code::file_format, node, "is reached twice: a cycle, or two parents");
      reached_[node.index] = true;
      waiting_.push_back({node.index, parent});
    }
  }

  const Json& root_;
  std::vector<bool> reached_;
  std::vector<Waiting> waiting_;
  std::vector<GltfInstance> instances_;
};

}  // namespace

Vec3 Affine::apply(const Vec3& p) const noexcept {
  const auto dot = [&](const std::array<double, 4>& row) {
    return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
  };
  return {dot(rows[0]), dot(rows[1]), dot(rows[2])};
}

std::vector<GltfInstance> gltf_instances(const Json& root) {
  const bool has_scene = !array_member(root, "scenes", {"top", 0}).empty();
  if (!has_scene && !root.contains("scene")) {
    if (array_member(root, "meshes", {"top", 0}).empty()) return {};
    throw Failure({Code::file_format, 0, "glTF has meshes but no scene that shows them"});
  }
  // Without a default scene the first one is shown, as viewers do.
  const GltfPlace place{"scene", unsigned_member(root, "scene", {"top", 0}, 0)};
  return Walk(root).from(gltf_object(root, "scenes", place), place);
}

}  // namespace cdfr
