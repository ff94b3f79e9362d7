/// The verbs of the command line. Each adds its options and what it does to the program.
#pragma once

#include "command_line.h"

namespace cdfr::command {

void add_audit(CLI::App& program);
void add_build(CLI::App& program);
void add_info(CLI::App& program);
void add_query(CLI::App& program);
void add_grid(CLI::App& program);
void add_contour(CLI::App& program);
void add_sections(CLI::App& program);
void add_thickness(CLI::App& program);
void add_make_part(CLI::App& program);

}  // namespace cdfr::command
