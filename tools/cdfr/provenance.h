/// Where a report comes from: enough to make it again, and to tell whether it would be the same.
#pragma once

#include <string>
#include <vector>

#include "cdfr/mesh/audit.h"
#include "command_line.h"
#include "input.h"
#include "json_report.h"

namespace cdfr::command {

struct Provenance {
  std::string input;                 ///< name as given
  std::string sha256;                ///< of the file's bytes, in hexadecimal
  std::string version;               ///< of cdfr
  std::vector<std::string> options;  ///< those that were given, as words
  std::string unit;                  ///< empty if nobody has named one
  std::string sign;                  ///< how inside is told from outside
  std::string audit;                 ///< why that sign, in one line
};

/// Reads all of the file once more, in pieces; of the bytes that it has now. Ends the program (Stop) if they
/// cannot be read, or on a signal.
Provenance provenance_of(const std::string& input, const CLI::App& verb, const std::string& unit, Sign sign,
                         const MeshReport& report);
/// The same of what was opened.
Provenance provenance_of(const std::string& name, const CLI::App& verb, const Input& input);

/// Keys are the names of the members.
Json json_of(const Provenance& provenance);
/// "input: part.stl", one line each, safe for a terminal and for a comment in a file.
std::vector<std::string> lines_of(const Provenance& provenance);

}  // namespace cdfr::command
