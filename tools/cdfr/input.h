/// INPUT of a verb that needs a field: a saved one, or a mesh that is built first.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"
#include "settings.h"

namespace cdfr::command {

struct Input {
  Field field;
  std::string unit;          ///< --unit, else what the file says
  std::optional<Mesh> mesh;  ///< if INPUT was one
  double seconds = 0;        ///< taken by reading and building
};

/// Told by content, and by the name ".cdfr".
bool is_saved_field(const std::filesystem::path& path);

enum class Demand {
  any_field,
  inside,  ///< one that tells inside from outside
};

/// Ends the program (Stop) if the mesh or field cannot be had, or does not meet the demand: for a mesh that
/// is found before it is built.
Input open_input(const std::filesystem::path& path, const Settings& settings,
                 Demand demand = Demand::any_field);

/// The mesh to draw: INPUT itself, or `part` for a saved field. Ends the program (Stop) if that is not its
/// mesh.
Mesh drawn_mesh(const std::string& part, const Input& input);

}  // namespace cdfr::command
