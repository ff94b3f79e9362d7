/// What the verb sections was asked, and what it has found.
#pragma once

#include <optional>
#include <string>
#include <vector>

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
  double density = 0;  ///< 0: no mass is asked for
  Settings settings;
};

struct SectionsFinding {
  Sections sections;
  std::optional<Sections> former;
  std::vector<SectionChange> changes;  ///< if there is a former revision
  Provenance provenance;
  double seconds = 0;
};

}  // namespace cdfr::command
