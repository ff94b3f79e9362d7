#include "field/side.h"

#include "geometry/box_distance.h"
#include "mesh/crossings.h"

namespace cdfr {
namespace {

int by_crossings(const FieldData& field, const Vec3& p) noexcept {
  return winding_by_crossings(p, field.space()) > 0 ? -1 : 1;
}

/// The zero vector stands for normals that do not tell.
bool has_normal(const FieldData& field, const Winner& winner) noexcept {
  const TriangleRecord& record = field.triangles.records[winner.slot];
  const TrianglePlace place = winner.foot.place;
  if (place == 0) return true;
  const Vec3& normal = place < 4 ? field.pseudonormals.edges[record.edges[place - 1]]
                                 : field.pseudonormals.vertices[record.vertices[place - 4]];
  return normal != Vec3{};
}

int by_normals(const FieldData& field, const Vec3& p, const Winner& winner) noexcept {
  const TriangleRecord& record = field.triangles.records[winner.slot];
  const Sides sides = field.sign == Sign::pseudonormal ? Sides::outward : record.sides;
  if (sides == Sides::unknown || !has_normal(field, winner)) return by_crossings(field, p);
  if (sides == Sides::both_inside) return -1;
  if (sides == Sides::both_outside) return 1;
  const int side = side_of_normals(winner.foot, record, field.pseudonormals);
  return side != 0 ? side : by_crossings(field, p);
}

}  // namespace

int side_of(const FieldData& field, const Vec3& p, const Winner& winner) noexcept {
  if (field.sign == Sign::none || winner.foot.squared.hi == 0) return 1;
  if (winner.side == Side::inside) return -1;
  if (winner.side == Side::outside) return 1;
  if (field.far_side != 0 && !contains(field.bounds(), p)) return field.far_side;
  if (!field.winding.empty()) return winds(field.winding, field.space(), p) ? -1 : 1;
  return by_normals(field, p, winner);
}

}  // namespace cdfr
