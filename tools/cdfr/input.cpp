#include "input.h"

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string_view>
#include <utility>

#include "cdfr/mesh/audit.h"
#include "cdfr/mesh/flip.h"
#include "cdfr/mesh/read.h"
#include "cdfr/store/store.h"
#include "output_target.h"
#include "steering.h"
#include "stop.h"

namespace cdfr::command {
namespace {

constexpr std::string_view saved_magic = "cdfr\r\n\x1a\n";

constexpr const char* no_inside =
    "the field is unsigned (sign: none), so there is no inside and no depth; see cdfr audit";

/// Says that the sign was chosen, and why not the usual one.
void note_sign(const Field& field, const Settings& settings) {
  if (settings.quiet || field.options().sign != Sign::automatic || field.sign() == Sign::pseudonormal) return;
  std::fprintf(stderr, "note: sign by %s: %s\n", sign_text(field.sign()),
               sign_reason(field.report()).c_str());
}

Input build_mesh(const std::filesystem::path& path, const Settings& settings, Demand demand) {
  if (demand == Demand::inside && settings.build.sign == Sign::none) stop_failed(path, no_inside);
  Mesh mesh = need(read_mesh(path), path);
  if (settings.flip) flip(mesh);
  Steering steering(settings, "building");
  Field field = need(Field::build(mesh.view(), settings.build, steering.run()), path);
  return {std::move(field), settings.unit, std::move(mesh)};
}

Input load_field(const std::filesystem::path& path, const Settings& settings) {
  if (const std::string option = settings.given_build_option(); !option.empty()) {
    stop_usage(option + " means nothing here: '" + path.string() + "' is a saved field");
  }
  StoredField stored = need(load(path), path);
  need(stored.field.status(), path);
  std::string unit = settings.unit.empty() ? std::move(stored.unit) : settings.unit;
  return {std::move(stored.field), std::move(unit), std::nullopt};
}

}  // namespace

bool is_saved_field(const std::filesystem::path& path) {
  if (extension_of(path) == ".cdfr") return true;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::array<char, saved_magic.size()> first{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(first.data(), first.size());
  return stream && std::string_view(first.data(), first.size()) == saved_magic;
}

Input open_input(const std::filesystem::path& path, const Settings& settings, Demand demand) {
  const auto start = std::chrono::steady_clock::now();
  Input input = is_saved_field(path) ? load_field(path, settings) : build_mesh(path, settings, demand);
  if (demand == Demand::inside && input.field.sign() == Sign::none) stop_failed(path, no_inside);
  if (settings.level_option != nullptr && settings.level_option->count() > 0)
    input.field = need(input.field.at_level(settings.level), path);
  note_sign(input.field, settings);
  input.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return input;
}

Mesh drawn_mesh(const std::string& part, const Input& input) {
  if (part.empty()) {
    if (!input.mesh) stop_usage("a saved field is drawn on --part MESH: it keeps no vertices by file order");
    return *input.mesh;
  }
  Mesh mesh = need(read_mesh(part), part);
  if (mesh.triangles.size() != input.field.report().triangles)
    stop_failed(part, "not the field's mesh: it has another number of triangles");
  return mesh;
}

}  // namespace cdfr::command
