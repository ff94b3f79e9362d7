#include <limits>
#include <memory>
#include <utility>

#include "cdfr/field/field.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "field/build_field.h"
#include "field/query.h"

namespace cdfr {

Result<BruteForce> BruteForce::over(MeshView mesh, Sign sign) {
  BuildOptions options;
  options.sign = sign;
  const FloatingEnvironment environment;
  const Run run;
  Progress progress(run);
  Result<FieldData> data = Progress::error();
  with_threads(run, [&] { data = prepare_field(mesh, options, progress); });
  if (!data) return data.error();
  return BruteForce(std::make_shared<const FieldData>(std::move(data).value()));
}

Closest BruteForce::closest(Vec3 x) const noexcept { return closest_point(*data_, x, Finder::brute); }

Closest closest_brute(MeshView mesh, Vec3 x, Sign sign) {
  const Result<BruteForce> brute = BruteForce::over(mesh, sign);
  if (brute) return brute->closest(x);
  Closest nothing;
  nothing.distance = std::numeric_limits<double>::quiet_NaN();
  return nothing;
}

}  // namespace cdfr
