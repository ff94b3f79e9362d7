#include "tables/subjects.h"

#include <cstdio>
#include <utility>

#include "models.h"

namespace cdfr::bench {
namespace {

const Subject like_connector{"kcl_focusrite-scarlett-mounting-bracket_d3_a60", true};
const Subject like_brevi{"NIST_MBE_PMI_1_d3_a40", true};
const Subject like_head{"head_res222", true};

}  // namespace

std::vector<PaperPart> paper_parts() {
  return {{"cube", 12, 5, 5, 5, 2.5},
          {"tetrahedron", 4, 1, 1, 1, 0.2},
          {"one-tooth", 16, 1, 2, 2, 0.48},
          {"six-star", 48, 1, 3, 3.46, 0.49},
          {"two-ended-tooth", 0, 0, 0, 0, 0},
          {"connector", 327, 6.9, 2.0, 2.9, 0.50},
          {"brevi", 1812, 38.1, 34.9, 96.0, 13.0},
          {"cylinder-head", 135429, 480, 266, 157, 0},
          {"engine", 130000, 600, 300, 250, 11}};
}

std::vector<Subject> real_parts() { return {like_connector, like_brevi, like_head}; }

std::vector<FieldCase> field_cases() {
  std::vector<FieldCase> cases;
  for (const auto& [table, resolution] : {std::pair{"2", 32}, std::pair{"3", 64}}) {
    for (const char* part : {"cube", "tetrahedron", "one-tooth", "six-star"})
      cases.push_back({table, {part}, resolution});
  }
  for (const Subject& subject :
       {Subject{"connector"}, Subject{"brevi"}, like_connector, like_brevi}) {
    for (const int resolution : {128, 256}) cases.push_back({"4", subject, resolution});
  }
  return cases;
}

std::vector<ContourCase> contour_cases() {
  std::vector<ContourCase> cases;
  const auto add = [&](const Subject& subject, double depth, double deepest) {
    ContourCase& which = cases.emplace_back();
    which.subject = subject;
    which.depth = depth;
    which.deepest = deepest;
    return &which;
  };
  const auto add_simple = [&](const char* part, double depth, double deepest) {
    ContourCase& which = *add({part}, depth, deepest);
    which.table = "5 and 6";
    which.field_resolutions = {32, 64};
    which.contour_resolutions = {128, 192, 384};
  };
  const auto add_large = [&](const Subject& subject, double depth, double deepest) {
    ContourCase& which = *add(subject, depth, deepest);
    which.table = "7";
    which.field_resolutions = {128, 256};
    which.contour_resolutions = {512, 768, 1024};
  };
  add_simple("cube", 0.6, 2.5);
  add_simple("tetrahedron", 0.1, 0.2);
  add_simple("one-tooth", 0.2, 0.48);
  add_simple("six-star", 0.35, 0.49);
  add_large({"connector"}, 0.3, 0.5);
  add_large({"brevi"}, 4, 13);
  add_large(like_connector, 0.3, 0.5);
  add_large(like_brevi, 4, 13);
  return cases;
}

std::optional<Mesh> mesh_of(const Subject& subject) {
  Model model{subject.name, ""};
  if (subject.is_real) {
    const std::vector<Model> found = public_models(subject.name + ".");
    if (found.empty()) {
      std::fprintf(stderr, "bench: left out, not here: %s\n", subject.name.c_str());
      return std::nullopt;
    }
    model = found.front();
  }
  Result<Mesh> mesh = load_model(model);
  if (!mesh) {
    std::fprintf(stderr, "bench: %s: %s\n", subject.name.c_str(), mesh.error().text.c_str());
    return std::nullopt;
  }
  return std::move(mesh).value();
}

}  // namespace cdfr::bench
