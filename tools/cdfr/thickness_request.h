/// What cdfr thickness was asked, and what came of it.
#pragma once

#include <optional>
#include <string>

#include "cdfr/analysis/thickness.h"
#include "command_line.h"
#include "input.h"
#include "provenance.h"
#include "settings.h"

namespace cdfr::command {

struct ThicknessRequest {
  std::string input, output, part, against;
  ThicknessOptions options;
  ThinningOptions thinning;
  double density = 0;
  Settings settings;
  const CLI::App* verb = nullptr;
};

struct ThicknessFinding {
  Thickness walls;
  std::optional<Thinning> thinning;
  Provenance provenance;
  double seconds = 0;
};

}  // namespace cdfr::command
