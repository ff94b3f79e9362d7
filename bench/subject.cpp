#include "subject.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "cdfr/core/run.h"
#include "random.h"

namespace cdfr::bench {
namespace {

constexpr std::size_t query_count = 10'000;
constexpr std::size_t depth_samples = 1000;

Box scaled(const Box& box, double factor) {
  const double by = (factor - 1) / 2;
  const Vec3 grow{(box.hi.x - box.lo.x) * by, (box.hi.y - box.lo.y) * by, (box.hi.z - box.lo.z) * by};
  return {{box.lo.x - grow.x, box.lo.y - grow.y, box.lo.z - grow.z},
          {box.hi.x + grow.x, box.hi.y + grow.y, box.hi.z + grow.z}};
}

double side(const Box& box) {
  return std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
}

Vec3 near_surface(const Field& field, Vec3 from, double reach, Random& random) {
  const Vec3 foot = field.closest(from).point;
  return random.in(
      {{foot.x - reach, foot.y - reach, foot.z - reach}, {foot.x + reach, foot.y + reach, foot.z + reach}});
}

}  // namespace

Result<Subject> make_subject(Mesh mesh) {
  Result<Field> field = Field::build(mesh.view());
  if (!field) return field.error();
  Subject subject{.mesh = std::move(mesh), .field = *field};
  const Box box = scaled(field->bounds(), 1.1);
  subject.longest_side = side(field->bounds());

  Random random;
  double lowest = 0, highest = 0;
  for (std::size_t i = 0; i < query_count; ++i) subject.anywhere.push_back(random.in(box));
  for (std::size_t i = 0; i < depth_samples; ++i) {
    const double distance = field->distance(random.in(field->bounds()));
    lowest = std::min(lowest, distance);
    highest = std::max(highest, distance);
  }
  subject.contour_distance = (lowest < 0 ? lowest : highest) / 4;
  for (const Vec3& point : subject.anywhere) {
    subject.near_surface.push_back(near_surface(*field, point, subject.longest_side / 1000, random));
  }
  return subject;
}

}  // namespace cdfr::bench
