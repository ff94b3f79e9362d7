/// Options whose values are words.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace cdfr::command {

/// An option whose value is one of a few words. Target and choices must outlive the parsing.
template <class Value>
CLI::Option* add_choice(CLI::App& verb, const std::string& name, Value& target,
                        const std::map<std::string, Value>& choices, const std::string& description) {
  const auto set = [name, &target, &choices](const std::string& word) {
    const auto found = choices.find(word);
    if (found != choices.end()) return void(target = found->second);
    std::string known;
    for (const auto& choice : choices) known += (known.empty() ? "" : ", ") + choice.first;
    throw CLI::ValidationError(name, "'" + word + "' is none of " + known);
  };
  return verb.add_option_function<std::string>(name, set, description)->type_name("WORD");
}

}  // namespace cdfr::command
