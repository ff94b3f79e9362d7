/// The meshes of the soak, in an order without end: models and made meshes in turn, then made ones alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oracle/models.h"
#include "soak/shape.h"

namespace cdfr::soak {

struct Candidate {
  std::string name;        ///< "wedge/3", "model/part_cube": with the seed it makes the same mesh again
  std::string text;        ///< what it is
  Mesh mesh;               ///< what the field is built of
  Mesh clean;              ///< as welded() leaves it, for all else
  std::uint64_t seed = 0;  ///< for its points
};

class Catalogue {
 public:
  explicit Catalogue(std::uint64_t seed) : seed_(seed), models_(oracle::models()) {}

  /// Names in order.
  std::string name(std::uint64_t place) const;
  /// None if there is no such name, or its file cannot be read (`why` says which).
  std::optional<Candidate> make(const std::string& name, std::string& why) const;
  std::uint64_t model_count() const { return models_.size(); }

 private:
  std::optional<Shape> make_model(const std::string& name, std::string& why) const;
  std::optional<Shape> make_changed_model(std::uint64_t round, test::Random& random, std::string& why) const;

  std::uint64_t seed_;
  std::vector<oracle::Model> models_;
};

}  // namespace cdfr::soak
