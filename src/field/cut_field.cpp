#include "field/cut_field.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "octree/cut.h"

namespace cdfr {
namespace {

template <class T>
Array<T> of_sources(const Array<T>& before, const std::vector<std::uint64_t>& source, T otherwise) {
  if (before.empty()) return {};
  std::vector<T> after;
  for (const std::uint64_t leaf : source)
    after.push_back(leaf == CutOctree::no_leaf ? otherwise : before[leaf]);
  return after;
}

}  // namespace

FieldData cut_field(const FieldData& field, int level) {
  CutOctree cut = cut_at(field.tree, field.bvh, level);
  FieldData result = field;
  result.tree = std::move(cut.tree);
  result.index = LeafIndex(result.tree);
  result.leaf_windings.whole = of_sources(field.leaf_windings.whole, cut.source, LeafWindings::unknown);
  result.leaf_windings.place = of_sources(field.leaf_windings.place, cut.source, no_index);
  result.options.max_level = std::min(result.options.max_level, level);
  return result;
}

}  // namespace cdfr
