/// Who may include whom. Data goes left to right; a room includes rooms to its left only, those in braces do
/// not see each other:
///   core <- geometry <- mesh <- parts <- octree <- field
///        <- { contour, analysis, store, export, render, reference, distributed } <- c
/// A public header belongs to the room that its folder names. tools and bench include public headers and
/// their own files; a test includes public headers, test files, its own room and what that may include.
#pragma once

#include <string>
#include <vector>

#include "rooms/source_tree.h"

namespace cdfr::rooms {

/// One line "file:line: what" for each include that breaks the rule.
std::vector<std::string> include_violations(const SourceTree& tree);

}  // namespace cdfr::rooms
