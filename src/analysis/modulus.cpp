#include "cdfr/analysis/modulus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "analysis/critical_cells.h"
#include "analysis/material.h"
#include "analysis/task_cells.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Cells that one task after another takes.
constexpr int task_level = 1;
/// Of the sections' error that the default takes.
constexpr double default_share = 2;
/// Of e, to which curved surface counts as flat.
constexpr double flat_share = 0x1p-5;
/// Least e, as a share of the longest side: as of sections.
constexpr double least_error = 0x1p-14;
/// What sums round by, of the whole.
constexpr double sum_share = 0x1p-30;

class ModulusSearch {
 public:
  ModulusSearch(const FieldData& field, double error, std::span<const std::uint32_t> not_cooling,
                Progress& progress)
      : field_(field),
        error_(error),
        not_cooling_(not_cooling),
        progress_(progress),
        level_(level_of_error(field.tree.lattice, 2 * error)),
        tasks_(task_cells(field.tree.lattice, std::min(level_, task_level))) {}

  Result<std::vector<Modulus>> run(const Sections& sections) {
    progress_.phase(0, 1, static_cast<double>(sections.sections.size() * tasks_.size()));
    std::vector<Modulus> moduli;
    for (const Section& section : sections.sections) {
      moduli.push_back(modulus_of(section));
      if (field_.failed()) return field_.status().error();
      if (progress_.cancelled()) return Progress::error();
    }
    return moduli;
  }

 private:
  Modulus modulus_of(const Section& section) {
    mark(section);
    const VolumeBounds material =
        is_whole(section) ? VolumeBounds{field_.report.volume, field_.report.volume} : material_of_marked();
    Modulus modulus;
    modulus.volume = (material.sure + material.possible) / 2;
    modulus.volume_error = (material.possible - material.sure) / 2 + modulus.volume * sum_share;
    modulus.cooling_area = cooling_area();
    const double none = std::numeric_limits<double>::infinity();
    const bool cools = modulus.cooling_area > 0;
    modulus.value = cools ? modulus.volume / modulus.cooling_area : none;
    modulus.error = cools ? modulus.volume_error / modulus.cooling_area + modulus.value * sum_share : none;
    return modulus;
  }

  void mark(const Section& section) {
    std::vector<std::uint8_t> numbers(field_.triangles.size());
    for (const std::uint32_t number : section.triangles) numbers[number] = 1;
    marked_.resize(numbers.size());
    for (std::uint32_t slot = 0; slot < marked_.size(); ++slot)
      marked_[slot] = numbers[field_.triangles.records[slot].number];
  }

  bool is_whole(const Section& section) const noexcept {
    return field_.report.embedded() && section.triangles.size() == field_.triangles.size();
  }

  Box box_of_marked() const noexcept {
    Box box{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (std::uint32_t slot = 0; slot < marked_.size(); ++slot) {
      if (marked_[slot] == 0) continue;
      for (const Vec3& v : field_.triangles.shape(slot).vertices) box = united(box, {v, v});
    }
    return box;
  }

  VolumeBounds material_of_marked() {
    const MaterialSearch search{marked_, box_of_marked(), level_, error_ * flat_share};
    std::vector<VolumeBounds> found(tasks_.size());
    for_chunks(tasks_.size(), 1, [&](std::size_t i, std::size_t) {
      if (!progress_.poll()) return;
      found[i] = MaterialDescent(field_, search, progress_).run(tasks_[i]);
      progress_.step();
    });
    VolumeBounds all;
    for (const VolumeBounds& part : found) {
      all.sure += part.sure;
      all.possible += part.possible;
    }
    return all;
  }

  double cooling_area() const noexcept {
    double twice = 0;
    for (std::uint32_t slot = 0; slot < marked_.size(); ++slot) {
      if (marked_[slot] == 0) continue;
      const ExactTriangle& triangle = field_.triangles.exact[slot];
      if (std::find(not_cooling_.begin(), not_cooling_.end(), triangle.patch) != not_cooling_.end()) continue;
      const auto& [a, b, c] = triangle.shape.vertices;
      const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
      const double x = u.y * v.z - u.z * v.y, y = u.z * v.x - u.x * v.z, z = u.x * v.y - u.y * v.x;
      twice += std::sqrt(x * x + y * y + z * z);
    }
    return twice / 2;
  }

  const FieldData& field_;
  double error_;
  std::span<const std::uint32_t> not_cooling_;
  Progress& progress_;
  int level_;
  std::vector<Cell> tasks_;
  std::vector<std::uint8_t> marked_;  ///< by slot: the section's
};

Result<void> check(const FieldData& field, const Sections& sections, double error) {
  const double rounding = 16 * point_rounding(std::max(largest_magnitude(field.bounds().lo),
                                                       largest_magnitude(field.bounds().hi)));
  if (!(error >= longest_side(field.bounds()) * least_error) || !(error >= 64 * rounding) ||
      !std::isfinite(error)) {
    return Error{
        Code::bad_option, 0,
        "the error must be at least 2^-14 of the longest side, and 2^14 ulp of the largest coordinate"};
  }
  for (const Section& section : sections.sections) {
    for (const std::uint32_t number : section.triangles) {
      if (number >= field.triangles.size())
        return Error{Code::bad_option, number, "a section has a triangle that the field has not"};
    }
  }
  if (field.sign == Sign::none)
    return Error{Code::not_closed, 0, "an unsigned field has no inside: sections have no material"};
  return {};
}

}  // namespace

Result<std::vector<Modulus>> section_moduli(const Field& field, const Sections& sections,
                                            const ModulusOptions& options, const Run& run) {
  const FieldData& data = field.data();
  const double error = options.error == 0 ? default_share * sections.error : options.error;
  if (Result<void> good = check(data, sections, error); !good) return good.error();
  const FloatingEnvironment environment;
  Progress progress(run);
  progress.watch(data.map.get());
  Result<std::vector<Modulus>> moduli = Progress::error();
  with_threads(run,
               [&] { moduli = ModulusSearch(data, error, options.not_cooling, progress).run(sections); });
  return moduli;
}

}  // namespace cdfr
