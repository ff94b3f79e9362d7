/// Options that several verbs share.
#pragma once

#include <string>
#include <vector>

#include "cdfr/core/run.h"
#include "cdfr/octree/options.h"
#include "command_line.h"

namespace cdfr::command {

struct Settings {
  int threads = 0;
  bool quiet = false;
  bool json = false;
  std::string unit;
  BuildOptions build;
  bool flip = false;
  int level = 0;  ///< to cut the octree at, if level_option was given
  const CLI::Option* level_option = nullptr;
  std::vector<const CLI::Option*> build_options;  ///< for telling which were given

  /// Name of a build option that was given, or empty.
  std::string given_build_option() const;
};

/// --json and --quiet.
void add_report_options(CLI::App& verb, Settings& settings);
void add_threads_option(CLI::App& verb, Settings& settings);
void add_unit_option(CLI::App& verb, Settings& settings);
/// All that Field::build takes.
void add_build_options(CLI::App& verb, Settings& settings);

/// What a verb on a field takes: all of the above.
void add_field_options(CLI::App& verb, Settings& settings);

const char* sign_text(Sign sign);
const char* lists_text(Lists lists);

}  // namespace cdfr::command
