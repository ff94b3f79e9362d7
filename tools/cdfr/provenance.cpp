#include "provenance.h"

#include <CLI/CLI.hpp>

#include "cdfr/version.h"
#include "file_hash.h"
#include "settings.h"
#include "terminal_text.h"

namespace cdfr::command {
namespace {

/// Options in the order in which the verb lists them, each with its values; INPUT is told elsewhere.
std::vector<std::string> options_given(const CLI::App& verb) {
  std::vector<std::string> words;
  for (const CLI::Option* option : verb.get_options()) {
    if (option->count() == 0 || option->get_positional()) continue;
    words.push_back(option->get_name());
    if (option->get_expected_min() == 0) continue;  // a flag
    for (const std::string& value : option->results()) words.push_back(value);
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + terminal_text(word);
  return text.empty() ? "none" : text;
}

}  // namespace

Provenance provenance_of(const std::string& input, const CLI::App& verb, const std::string& unit, Sign sign,
                         const MeshReport& report) {
  return {input, sha256_of(input), version(),          options_given(verb),
          unit,  sign_text(sign),  sign_reason(report)};
}

Provenance provenance_of(const std::string& name, const CLI::App& verb, const Input& input) {
  return provenance_of(name, verb, input.unit, input.field.sign(), input.field.report());
}

Json json_of(const Provenance& provenance) {
  return {{"input", provenance.input},     {"sha256", provenance.sha256}, {"version", provenance.version},
          {"options", provenance.options}, {"unit", provenance.unit},     {"sign", provenance.sign},
          {"audit", provenance.audit}};
}

std::vector<std::string> lines_of(const Provenance& provenance) {
  return {"input: " + terminal_text(provenance.input),
          "sha256: " + provenance.sha256,
          "cdfr: " + provenance.version,
          "options: " + joined(provenance.options),
          "unit: " + (provenance.unit.empty() ? "unknown" : terminal_text(provenance.unit)),
          "sign: " + provenance.sign,
          "audit: " + provenance.audit};
}

}  // namespace cdfr::command
