/// Models that are not closed: the sign is that of the winding number by its definition, wherever that is
/// more than 1e-6 from 1/2, whatever the octree's resolution. CDFR_POINTS sets the number of points as in
/// model_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "cdfr/field/field.h"
#include "cdfr/mesh/audit.h"
#include "oracle/models.h"
#include "oracle/point_count.h"
#include "oracle/random.h"
#include "oracle/samples.h"
#include "support/winding.h"

namespace cdfr::oracle {
namespace {

class WindingTest : public testing::TestWithParam<Model> {};

TEST_P(WindingTest, sign_is_that_of_the_winding_number) {
  const Result<Mesh> mesh = load(GetParam());
  if (!mesh) GTEST_SKIP() << "not readable: " << mesh.error().text;
  const Result<MeshReport> report = audit(mesh->view());
  if (!report) GTEST_SKIP() << "refused: " << report.error().text;
  if (report->balanced()) GTEST_SKIP() << "every edge balances: the exact oracle looks at this one";
  const std::size_t count = std::clamp<std::size_t>(point_count(mesh->triangles.size()) / 10, 9, 1000);
  for (const int level : {0, 2, short_run() ? 3 : 6}) {
    BuildOptions options;
    options.max_level = level;
    const Result<Field> field = Field::build(mesh->view(), options);
    ASSERT_TRUE(field) << field.error().text;
    EXPECT_EQ(field->sign(), Sign::winding);
    Random random(static_cast<std::uint64_t>(level) + 3);
    std::size_t wrong = 0;
    for (const Vec3& p : model_points(random, mesh->view(), *field, count)) {
      const double w = test::brute_winding(mesh->view(), p), distance = field->distance(p);
      const bool undecided = std::fabs(w - 0.5) <= 1e-6 || distance == 0;
      if (undecided || (distance < 0) == (w > 0.5)) continue;
      if (wrong++ < 3) {
        ADD_FAILURE() << "w = " << w << ", distance " << distance << " at " << std::hexfloat << p.x << ", "
                      << p.y << ", " << p.z;
      }
    }
    EXPECT_EQ(wrong, 0U) << "of " << count << " points at level " << level;
  }
  std::cout << GetParam() << ": " << mesh->triangles.size() << " triangles, " << count << " points a level, "
            << sign_reason(*report) << '\n';
}

INSTANTIATE_TEST_SUITE_P(Models, WindingTest, testing::ValuesIn(models()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace cdfr::oracle
