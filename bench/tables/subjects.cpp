#include "tables/subjects.h"

#include <cstdio>
#include <utility>

#include "models.h"

namespace cdfr::bench {
namespace {

const Subject like_connector{"kcl_focusrite-scarlett-mounting-bracket_d3_a60", true};
const Subject like_brevi{"NIST_MBE_PMI_1_d3_a40", true};
const Subject like_head{"head_res222", true};

ContourCase contour_case(const Subject& subject, double depth, double deepest,
                         const std::vector<int>& field_resolutions,
                         const std::vector<int>& contour_resolutions) {
  ContourCase made;
  made.subject = subject;
  made.depth = depth;
  made.deepest = deepest;
  made.field_resolutions = field_resolutions;
  made.contour_resolutions = contour_resolutions;
  return made;
}

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

std::vector<FieldCase> simple_fields(int resolution) {
  std::vector<FieldCase> cases;
  for (const char* part : {"cube", "tetrahedron", "one-tooth", "six-star"})
    cases.push_back({{part}, resolution});
  return cases;
}

std::vector<FieldCase> large_fields() {
  std::vector<FieldCase> cases;
  for (const Subject& subject : {Subject{"connector"}, Subject{"brevi"}, like_connector, like_brevi}) {
    for (const int resolution : {128, 256}) cases.push_back({subject, resolution});
  }
  return cases;
}

std::vector<ContourCase> simple_contours() {
  std::vector<ContourCase> cases;
  const auto add = [&](const char* part, double depth, double deepest) {
    cases.push_back(contour_case({part}, depth, deepest, {32, 64}, {128, 192, 384}));
  };
  add("cube", 0.6, 2.5);
  add("tetrahedron", 0.1, 0.2);
  add("one-tooth", 0.2, 0.48);
  add("six-star", 0.35, 0.49);
  return cases;
}

std::vector<ContourCase> large_contours() {
  std::vector<ContourCase> cases;
  const auto add = [&](const Subject& subject, double depth, double deepest) {
    cases.push_back(contour_case(subject, depth, deepest, {128, 256}, {512, 768, 1024}));
  };
  add({"connector"}, 0.3, 0.5);
  add({"brevi"}, 4, 13);
  add(like_connector, 0.3, 0.5);
  add(like_brevi, 4, 13);
  return cases;
}

std::optional<Mesh> mesh_of(const Subject& subject) {
  Model model{subject.name, ""};
  if (subject.is_real) {
    const std::vector<Model> found = public_models(model.name + ".");
    if (found.empty()) {
      std::fprintf(stderr, "bench: left out, not here: %s\n", subject.name);
      return std::nullopt;
    }
    model = found.front();
  }
  Result<Mesh> mesh = load_model(model);
  if (!mesh) {
    std::fprintf(stderr, "bench: %s: %s\n", subject.name, mesh.error().text.c_str());
    return std::nullopt;
  }
  return std::move(mesh).value();
}

}  // namespace cdfr::bench
