#include "settings.h"

#include <CLI/CLI.hpp>
#include <limits>
#include <map>

#include "choice_option.h"
#include "number_option.h"
#include "unit.h"

namespace cdfr::command {
namespace {

constexpr int most_threads = 1024;
constexpr int deepest_level = 18;

const std::map<std::string, Sign> signs{{"auto", Sign::automatic},
                                        {"automatic", Sign::automatic},
                                        {"pseudonormal", Sign::pseudonormal},
                                        {"winding", Sign::winding},
                                        {"none", Sign::none}};
const std::map<std::string, Lists> lists_by_name{{"corner", Lists::corner}, {"band", Lists::band}};

/// "band:2.5" says how wide.
CLI::Option* add_domain(CLI::App& verb, BuildOptions& build) {
  const auto set = [&build](const std::string& word) {
    const bool is_band = word.rfind("band:", 0) == 0;
    if (word == "box") {
      build.domain = Domain::box;
    } else if (word == "interior") {
      build.domain = Domain::interior;
    } else if (is_band && parse_number(word.substr(5), build.band) && build.band > 0) {
      build.domain = Domain::band;
    } else {
      throw CLI::ValidationError("--domain", "'" + word + "' is none of box, interior, band:DISTANCE");
    }
  };
  return verb
      .add_option_function<std::string>(
          "--domain", set,
          "Where leaves have lists of their own: box, interior or band:DISTANCE; exact everywhere")
      ->type_name("WORD");
}

}  // namespace

std::string Settings::given_build_option() const {
  for (const CLI::Option* option : build_options) {
    if (option->count() > 0) return option->get_name();
  }
  return {};
}

void add_report_options(CLI::App& verb, Settings& settings) {
  verb.add_flag("--json", settings.json, "Print one JSON object on standard output and nothing else there");
  verb.add_flag("--quiet", settings.quiet, "No progress, notes or summary; errors are still told");
}

void add_threads_option(CLI::App& verb, Settings& settings) {
  add_count(verb, "--threads", settings.threads, 0, most_threads,
            "Worker threads; 0 takes what the machine has. Results never depend on it");
}

void add_unit_option(CLI::App& verb, Settings& settings) {
  const auto set = [&settings](const std::string& word) {
    if (const std::string fault = unit_fault(word); !fault.empty()) {
      throw CLI::ValidationError("--unit", fault);
    }
    settings.unit = word;
  };
  verb.add_option_function<std::string>("--unit", set, "Label of the mesh's unit of length, such as mm")
      ->type_name("NAME");
}

void add_build_options(CLI::App& verb, Settings& settings) {
  BuildOptions& build = settings.build;
  settings.build_options = {
      add_count(verb, "--max-triangles", build.max_triangles_per_leaf, 1, std::numeric_limits<int>::max(),
                "A cell with a longer list splits, if splitting pays (320)"),
      add_count(verb, "--queries", build.expected_queries, 1, std::uint64_t{1} << 60,
                "About how many queries will follow: list lengths for which build and queries take least"),
      add_count(verb, "--max-level", build.max_level, 0, deepest_level,
                "Deepest level of a leaf (5, and more for long and for fine parts)"),
      add_number(verb, "--margin", build.margin, {0, 1},
                 "The domain is the part's box grown by this share of its longest side (0.05)"),
      add_number(verb, "--gain", build.gain, {std::numeric_limits<double>::min(), 1},
                 "A split stays if the children's mean list is at most this share of the parent's (0.75)"),
      add_choice(verb, "--lists", build.lists, lists_by_name,
                 "Which triangles a leaf keeps: corner (the tight rule) or band (the source paper's)"),
      add_choice(verb, "--sign", build.sign, signs,
                 "How inside is told from outside: automatic (by the audit), pseudonormal, winding or none"),
      add_domain(verb, build),
      verb.add_flag("--flip", settings.flip,
                    "Turn the mesh inside out first: front and back of every triangle change places"),
  };
  verb.get_option("--queries")->excludes("--max-triangles");
  for (const CLI::Option* option : settings.build_options) {
    verb.get_option(option->get_name())->group("Build options (where INPUT is a mesh)");
  }
}

void add_field_options(CLI::App& verb, Settings& settings) {
  add_report_options(verb, settings);
  add_threads_option(verb, settings);
  add_unit_option(verb, settings);
  settings.level_option =
      add_count(verb, "--level", settings.level, 0, deepest_level,
                "Cut the octree at this level first: the same answers from fewer, longer leaves");
  add_build_options(verb, settings);
}

const char* sign_text(Sign sign) {
  switch (sign) {
    case Sign::automatic:
      return "automatic";
    case Sign::pseudonormal:
      return "pseudonormal";
    case Sign::winding:
      return "winding";
    case Sign::none:
      return "none";
  }
  return "unknown";
}

const char* lists_text(Lists lists) { return lists == Lists::band ? "band" : "corner"; }

}  // namespace cdfr::command
