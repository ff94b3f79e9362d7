#include "soak/catalogue.h"

#include <cstdlib>

#include "soak/changes.h"
#include "soak/families.h"
#include "soak/welded.h"

namespace cdfr::soak {
namespace {

const std::string model_prefix = "model/", changed_prefix = "changed-model/";

std::string made_name(std::uint64_t place) {
  const std::uint64_t kinds = families().size() + 1;
  const std::uint64_t kind = place % kinds, round = place / kinds;
  const std::string prefix =
      kind == families().size() ? changed_prefix : families()[kind].name + std::string("/");
  return prefix + std::to_string(round);
}

/// FNV-1a.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

std::optional<std::uint64_t> round_of(const std::string& name, const std::string& prefix) {
  if (!name.starts_with(prefix) || name.size() == prefix.size()) return std::nullopt;
  if (name.find_first_not_of("0123456789", prefix.size()) != std::string::npos) return std::nullopt;
  return std::strtoull(name.c_str() + prefix.size(), nullptr, 10);
}

}  // namespace

std::string Catalogue::name(std::uint64_t place) const {
  if (place >= 2 * models_.size()) return made_name(place - models_.size());
  return place % 2 == 0 ? model_prefix + models_[place / 2].name : made_name(place / 2);
}

std::optional<Shape> Catalogue::make_model(const std::string& name, std::string& why) const {
  for (const oracle::Model& model : models_) {
    if (model.name != name) continue;
    Result<Mesh> mesh = oracle::load(model);
    if (mesh) return Shape{"", std::move(*mesh)};
    why = mesh.error().text;
    return std::nullopt;
  }
  why = "no such model";
  return std::nullopt;
}

std::optional<Shape> Catalogue::make_changed_model(std::uint64_t round, test::Random& random,
                                                   std::string& why) const {
  const std::string& name = models_[random.below(models_.size())].name;
  std::optional<Shape> shape = make_model(name, why);
  if (!shape || shape->mesh.triangles.empty()) return std::nullopt;
  shape->text = name;
  return changed(std::move(*shape), round, random);
}

std::optional<Candidate> Catalogue::make(const std::string& name, std::string& why) const {
  std::optional<Shape> shape;
  test::Random random(test::Random(seed_ ^ hash_of(name)).bits());
  if (name.starts_with(model_prefix)) shape = make_model(name.substr(model_prefix.size()), why);
  if (const auto round = round_of(name, changed_prefix)) shape = make_changed_model(*round, random, why);
  for (const Family& family : families()) {
    const auto round = round_of(name, std::string(family.name) + "/");
    if (!round) continue;
    // As it is in even rounds, changed in odd ones.
    shape = family.make(*round / 2, random);
    if (*round % 2 == 1) shape = changed(std::move(*shape), *round / 2 + hash_of(family.name), random);
  }
  if (!shape) {
    if (why.empty()) why = "no such mesh";
    return std::nullopt;
  }
  Mesh clean = welded(shape->mesh);
  return Candidate{name, shape->text, std::move(shape->mesh), std::move(clean), random.bits()};
}

}  // namespace cdfr::soak
