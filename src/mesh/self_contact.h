/// Which triangles of a mesh meet others beyond the vertices and edges they share.
#pragma once

#include <cstdint>

#include "core/progress.h"
#include "core/scratch.h"
#include "mesh/bvh.h"

namespace cdfr {

/// By slot: 1 if the triangle is in contact with another one, as geometry/triangle_contact.h says it,
/// exactly. Duplicates and triangles of no area are in contact with nothing on that account.
///
/// Each triangle goes down the tree by itself and stops at its first contact, so the answer does not depend
/// on threads. O(n log n) for meshes whose boxes overlap near their neighbours alone, and for those that
/// cross themselves everywhere; at worst the number of pairs of triangles whose boxes overlap, to which
/// a vertex of degree k adds k^2. Runs in the caller's task arena and polls the progress; if that is
/// cancelled, triangles that were not reached are 0. Precondition: the space is not empty.
Large<std::uint8_t> self_contacts(SearchSpace space, Progress& progress, const Scratch* scratch = nullptr);

}  // namespace cdfr
