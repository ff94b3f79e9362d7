/// What the verb sections was asked, and what it has found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cdfr/analysis/modulus.h"
#include "cdfr/analysis/section_changes.h"
#include "cdfr/analysis/sections.h"
#include "input.h"
#include "provenance.h"
#include "settings.h"

namespace cdfr::command {

struct SectionsRequest {
  std::string input, output, against, part;
  double depth = 0;
  SectionsOptions options;
  double density = 0;                    ///< 0: no mass is asked for
  bool modulus = false;                  ///< is asked for
  std::vector<std::string> not_cooling;  ///< patches as they were named
  Settings settings;
};

struct SectionsFinding {
  Sections sections;
  std::vector<Modulus> moduli;  ///< of the sections, if they are asked for
  std::optional<Sections> former;
  std::vector<SectionChange> changes;  ///< if there is a former revision
  Provenance provenance;
  double seconds = 0;
};

}  // namespace cdfr::command
