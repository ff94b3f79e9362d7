// Wall thickness of shapes whose depths are closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "analysis/shapes.h"
#include "cdfr/analysis/thickness.h"
#include "oracle/wall_oracle.h"
#include "support/random.h"

namespace cdfr {
namespace {

constexpr double rounding = 1e-9;
constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3 inward(const Vec3& p, const Vec3& n, double way) {
  return {p.x - way * n.x, p.y - way * n.y, p.z - way * n.z};
}

double diagonal(const Box& b) { return std::hypot(b.hi.x - b.lo.x, b.hi.y - b.lo.y, b.hi.z - b.lo.z); }

class ThicknessOf : public testing::TestWithParam<std::size_t> {
 protected:
  static constexpr double chord = 0.01;
  static constexpr std::size_t most = 1500;

  Thickness measured(const ThicknessOptions& options) const { return thickness(field, options).value(); }
  std::size_t stride(const Thickness& walls) const { return walls.samples.size() / most + 1; }

  const test::Shape shape = test::shapes(chord)[GetParam()];
  const Field field = Field::build(shape.mesh.view()).value();
};
INSTANTIATE_TEST_SUITE_P(Shapes, ThicknessOf, testing::Range(std::size_t{0}, test::shapes(0.05).size()));

// Depths in the mesh differ from the solid's by at most the shape's error, so a ball that may enter the mesh
// by D is between those that may enter the solid by D less the error and by D and the error.
TEST_P(ThicknessOf, BallsLieBetweenThoseOfTheSolid) {
  SCOPED_TRACE(shape.name);
  for (const SampleAt at : {SampleAt::faces, SampleAt::vertices, SampleAt::spacing}) {
    ThicknessOptions options;
    options.at = at;
    options.spacing = 0.4;
    options.facet = std::max(3 * shape.error, 0.001);
    const Thickness walls = measured(options);
    EXPECT_EQ(walls.report.unmet, 0U);
    for (std::size_t i = 0; i < walls.samples.size(); i += stride(walls)) {
      const ThicknessSample& s = walls.samples[i];
      const oracle::Range truth = oracle::ball_diameter(
          shape.depth,
          {s.position, s.normal, options.facet, 2 * diagonal(field.bounds()), shape.error + rounding});
      ASSERT_TRUE(truth.meets(s.thickness, s.thickness + s.error))
          << "sample " << i << " of " << static_cast<int>(at) << " at " << s.position.x << ' ' << s.position.y
          << ' ' << s.position.z << ": " << s.thickness << " + " << s.error << " not in " << truth.low
          << " to " << truth.high;
    }
  }
}

/// Where a ray into the solid leaves it: after the depth has first exceeded `error`, from where it is that
/// again to where it is surely outside.
oracle::Range way_through(const test::Shape& shape, const Vec3& p, const Vec3& n, double longest) {
  const double doubt = shape.error + rounding, least = std::max(doubt / 4, 1e-7);
  const auto depth = [&](double way) { return shape.depth(inward(p, n, way)); };
  double way = 0;
  while (depth(way) <= doubt && way < longest) way += least;
  while (depth(way) > doubt && way < longest) way += std::max(depth(way) - doubt, least);
  oracle::Range range{way - least, infinity};
  while (depth(way) >= -doubt && way < longest) way += least;
  if (way < longest) range.high = way;
  return range;
}

TEST_P(ThicknessOf, RaysEndWhereTheyLeaveTheSolid) {
  SCOPED_TRACE(shape.name);
  ThicknessOptions options;
  options.method = ThicknessMethod::ray;
  const Thickness walls = measured(options);
  EXPECT_EQ(walls.report.unmet, 0U);
  for (std::size_t i = 0; i < walls.samples.size(); i += stride(walls)) {
    const ThicknessSample& s = walls.samples[i];
    const oracle::Range truth = way_through(shape, s.position, s.normal, 2 * diagonal(field.bounds()));
    ASSERT_TRUE(truth.meets(s.thickness - s.error, s.thickness + s.error))
        << "sample " << i << " at " << s.position.x << ' ' << s.position.y << ' ' << s.position.z << ": "
        << s.thickness << " not in " << truth.low << " to " << truth.high;
  }
}

// A sample close to a named place, whose face the place lies on, has nearly its thickness: moving a ball's
// touching point by m moves its centre by about m, and the ball meets what held it within twice that; more
// where the wall is no face but a fillet or a ball, so only places on faces are looked at.
TEST_P(ThicknessOf, NamedPlacesHaveTheirDiameter) {
  SCOPED_TRACE(shape.name);
  ThicknessOptions options;
  options.at = SampleAt::spacing;
  options.spacing = 0.1;
  options.facet = 3 * shape.error;
  const Thickness walls = measured(options);
  for (const test::Place& place : shape.places) {
    double nearest = infinity;
    const ThicknessSample* found = nullptr;
    for (const ThicknessSample& s : walls.samples) {
      const Vec3 to{s.position.x - place.point.x, s.position.y - place.point.y, s.position.z - place.point.z};
      const double away = std::hypot(to.x, to.y, to.z);
      const Vec3 &n = s.normal, &m = place.normal;
      if (n.x * m.x + n.y * m.y + n.z * m.z > 0.99 && away < nearest) nearest = away, found = &s;
    }
    ASSERT_NE(found, nullptr);
    EXPECT_LT(nearest, 0.5);
    EXPECT_NEAR(found->thickness, place.sphere, 0.1 * place.sphere + 2 * nearest)
        << place.point.x << ' ' << place.point.y << ' ' << place.point.z;
  }
}

TEST_P(ThicknessOf, MoreToleranceMakesItNoThinner) {
  SCOPED_TRACE(shape.name);
  ThicknessOptions options;
  options.facet = 0;
  Thickness before = measured(options);
  for (const double facet : {1e-6, 0.01, 0.1, 0.5}) {
    options.facet = facet;
    Thickness walls = measured(options);
    ASSERT_EQ(walls.samples.size(), before.samples.size());
    for (std::size_t i = 0; i < walls.samples.size(); ++i) {
      const ThicknessSample& s = walls.samples[i];
      ASSERT_LE(before.samples[i].thickness, s.thickness + s.error + rounding) << facet << " sample " << i;
    }
    before = std::move(walls);
  }
}

TEST_P(ThicknessOf, NoBallIsLargerThanTheLargest) {
  SCOPED_TRACE(shape.name);
  for (const double facet : {0.0, 0.02, 0.3}) {
    ThicknessOptions options;
    options.facet = facet;
    const double bound = 2 * (shape.balls.front().radius + shape.error) + 2 * facet + rounding;
    const Thickness walls = measured(options);
    for (const ThicknessSample& s : walls.samples) ASSERT_LE(s.thickness, bound);
  }
}

// In a convex part a ball that touches the face with normal n at p, and has its centre c = p - r n, is held
// by the face with normal m and height h over p where h + r (m n) = r.
double between_faces(const Mesh& mesh, const ThicknessSample& s) {
  double radius = infinity;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    const Vec3 m{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double length = std::hypot(m.x, m.y, m.z);
    const double height =
        ((a.x - s.position.x) * m.x + (a.y - s.position.y) * m.y + (a.z - s.position.z) * m.z) / length;
    const double lean = 1 - (m.x * s.normal.x + m.y * s.normal.y + m.z * s.normal.z) / length;
    if (lean > 1e-9) radius = std::min(radius, std::max(height, 0.0) / lean);
  }
  return 2 * radius;
}

TEST(ThicknessOfConvexParts, IsExactWithoutTolerance) {
  for (const test::Shape& shape : {test::box(0), test::cube(0), test::corner(0), test::plate(0)}) {
    SCOPED_TRACE(shape.name);
    const Field field = Field::build(shape.mesh.view()).value();
    ThicknessOptions options;
    options.at = SampleAt::spacing;
    options.spacing = 0.3;
    options.facet = 0;
    const Thickness walls = thickness(field, options).value();
    for (const ThicknessSample& s : walls.samples) {
      const double truth = between_faces(shape.mesh, s);
      ASSERT_LE(s.thickness, truth + 1e-12);
      ASSERT_GE(s.thickness + s.error, truth - 1e-12);
      ASSERT_LE(s.error, walls.report.error + 1e-12);
    }
  }
}

}  // namespace
}  // namespace cdfr
