#include "settings.h"

#include <cstdint>

namespace cdfr::bench {
namespace {

Setting field_of(std::string name, int threshold, int level) {
  BuildOptions options;
  options.max_triangles_per_leaf = threshold;
  options.max_level = level;
  return {std::move(name), options, [options](const Mesh& mesh) { return build_cdfr(mesh, options, 1); }};
}

Setting field_for(double queries, const char* name) {
  BuildOptions options;
  options.expected_queries = static_cast<std::uint64_t>(queries);
  return {name, options, [options](const Mesh& mesh) { return build_cdfr(mesh, options, 1); }};
}

}  // namespace

std::vector<Setting> settings(bool quick) {
  const std::vector<int> thresholds =
      quick ? std::vector{40, 160, 640} : std::vector{20, 40, 80, 160, 320, 640};
  const std::vector<int> levels = quick ? std::vector{3, 5} : std::vector{2, 3, 4, 5, 6, 7};
  std::vector<Setting> list{field_of(bvh_name, BuildOptions{}.max_triangles_per_leaf, 0)};
  list.push_back(field_for(1, "for 1 query"));
  list.push_back(field_for(1e3, "for 1e3 queries"));
  list.push_back(field_for(1e5, "for 1e5 queries"));
  list.push_back(field_for(1e6, "for 1e6 queries"));
  for (const int level : levels) {
    for (const int threshold : thresholds) {
      const std::string name = "level " + std::to_string(level) + ", list " + std::to_string(threshold);
      list.push_back(field_of(name, threshold, level));
    }
  }
  for (const SystemKind& kind : peer_kinds()) {
    list.push_back({kind.name, {}, [build = kind.build](const Mesh& mesh) { return build(mesh, 1); }});
  }
  return list;
}

}  // namespace cdfr::bench
