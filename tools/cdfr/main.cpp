/// The cdfr command: exact distances to a mesh, from a shell.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "cdfr/version.h"
#include "interrupt.h"
#include "stop.h"
#include "terminal_text.h"
#include "verbs.h"

namespace cdfr::command {
namespace {

int say(int status, const std::string& line) {
  std::fprintf(stderr, "cdfr: %s\n", line.c_str());
  return status;
}

/// One line, whatever the parser's message looks like.
int say_usage(const CLI::App& program, const CLI::ParseError& error) {
  std::string line = error.what();
  std::replace(line.begin(), line.end(), '\n', ' ');
  const auto verbs = program.get_subcommands();
  const std::string help = verbs.empty() ? "cdfr --help" : "cdfr " + verbs.front()->get_name() + " --help";
  return say(status_usage, terminal_text(line) + " (see " + help + ")");
}

/// The examples of all verbs, each of which is also at the end of its own help.
std::string all_examples(const CLI::App& program) {
  std::string text = "Examples:";
  for (const CLI::App* verb : program.get_subcommands({})) {
    const std::string own = verb->get_footer();
    text += own.substr(std::min(own.find('\n'), own.size()));
  }
  return text;
}

void set_up(CLI::App& program) {
  program.name("cdfr");
  program.set_version_flag("--version", std::string("cdfr ") + version());
  program.require_subcommand(1);
  add_audit(program);
  add_build(program);
  add_info(program);
  add_query(program);
  add_grid(program);
  add_contour(program);
  add_sections(program);
  add_thickness(program);
  add_make_part(program);
  program.footer(all_examples(program));
}

int run(int argc, char** argv) {
  CLI::App program("Exact distance from any point to a triangle mesh");
  set_up(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    return say_usage(program, error);
  }
  return status_done;
}

int guarded(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const Stop& stop) {
    return say(stop.status(), stop.what());
  } catch (const std::bad_alloc&) {
    return say(status_failed, "memory: not enough of it for this work");
  } catch (const std::exception& error) {
    return say(status_failed, terminal_text(error.what()));
  }
}

}  // namespace
}  // namespace cdfr::command

int main(int argc, char** argv) {
  cdfr::command::catch_interrupts();
  return cdfr::command::guarded(argc, argv);
}
