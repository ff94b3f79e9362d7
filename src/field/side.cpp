#include "field/side.h"

#include <algorithm>

#include "geometry/box_distance.h"
#include "mesh/crossings.h"

namespace cdfr {
namespace {

int by_crossings(const FieldData& field, const Vec3& p) noexcept {
  if (const int side = side_by_leaf(field, p)) return side;
  return winding_by_crossings(p, field.space()) > 0 ? -1 : 1;
}

int by_winding(const FieldData& field, const Vec3& p) noexcept {
  if (const int side = side_by_leaf(field, p)) return side;
  return winds(field.winding, field.space(), p) ? -1 : 1;
}

double reach_of(const Vec3& p, const TriangleShape& triangle) noexcept {
  double reach = 0;
  for (const Vec3& v : triangle.vertices)
    reach = std::max(reach, distance_between(p, v) * (1 + 8 * unit_roundoff));
  return reach;
}

/// What the surface around one feature says, if that is the closest one; 0 if it does not tell.
int by_normals(const FieldData& field, const Vec3& p, const Foot& foot, std::uint32_t slot) noexcept {
  const TriangleRecord& record = field.triangles.records[slot];
  const Sides sides = field.sign == Sign::pseudonormal ? Sides::outward : record.sides;
  if (sides == Sides::unknown) return 0;
  const bool on_face = foot.place == 0;
  const Vec3 normal = on_face ? Vec3{} : field.pseudonormals.at(foot.place, record);
  if (!on_face && normal == Vec3{}) return 0;
  if (sides == Sides::both_inside) return -1;
  if (sides == Sides::both_outside) return 1;
  if (on_face) return foot.along.hi > 0 ? 1 : -1;
  return side_of_normal(foot, normal, reach_of(p, field.triangles.shape(slot)));
}

/// All that may be closest have to agree.
int by_closest(const FieldData& field, const Vec3& p, const Finding& finding) noexcept {
  int side = finding.crowded ? 0 : by_normals(field, p, finding.winner.foot, finding.winner.slot);
  for (std::uint8_t i = 0; i < finding.rival_count && side != 0; ++i) {
    const std::uint32_t slot = finding.rivals[i];
    if (by_normals(field, p, measure(p, field.triangles.shape(slot)), slot) != side) side = 0;
  }
  return side != 0 ? side : by_crossings(field, p);
}

}  // namespace

int side_of(const FieldData& field, const Vec3& p, const Finding& finding) noexcept {
  if (field.sign == Sign::none || finding.winner.foot.squared.hi == 0) return 1;
  if (finding.leaf == Side::inside) return -1;
  if (finding.leaf == Side::outside) return 1;
  if (field.far_side != 0 && !contains(field.bounds(), p)) return field.far_side;
  if (!field.winding.empty()) return by_winding(field, p);
  return by_closest(field, p, finding);
}

std::optional<int> winding_by_closest(const FieldData& field, const Vec3& p) noexcept {
  const Finding finding = find_closest(field, p);
  const Winner& winner = finding.winner;
  const bool is_alone = !finding.crowded && finding.rival_count == 0 && winner.foot.squared.hi > 0;
  if (!is_alone || field.triangles.records[winner.slot].sides != Sides::outward) return std::nullopt;
  const int side = by_normals(field, p, winner.foot, winner.slot);
  return side != 0 ? std::optional(side < 0 ? 1 : 0) : std::nullopt;
}

}  // namespace cdfr
