#include <utility>

#include "cdfr/field/field.h"
#include "system.h"

namespace cdfr::bench {
namespace {

class CdfrSystem final : public System {
 public:
  explicit CdfrSystem(Field field) : field_(std::move(field)) {}

  std::size_t bytes() const override { return field_.stats().bytes; }
  void singles(std::span<const Vec3> points, std::span<double> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = field_.distance(points[i]);
  }
  void batch(std::span<const Vec3> points, std::span<double> out, unsigned threads) const override {
    field_.distance(points, out, {.threads = threads}).value();
  }
  void fill(const SampleGrid& grid, std::span<double> out, unsigned threads) const override {
    field_.distance(Grid{grid.origin, grid.spacing, grid.size}, out, {.threads = threads}).value();
  }

 private:
  Field field_;
};

}  // namespace

Result<std::unique_ptr<System>> build_cdfr(const Mesh& mesh, const BuildOptions& options, unsigned threads) {
  Result<Field> field = Field::build(mesh.view(), options, {.threads = threads});
  if (!field) return field.error();
  return {std::make_unique<CdfrSystem>(std::move(*field))};
}

Result<std::unique_ptr<System>> build_cdfr(const Mesh& mesh, unsigned threads) {
  return build_cdfr(mesh, BuildOptions{}, threads);
}

}  // namespace cdfr::bench
