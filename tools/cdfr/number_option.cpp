#include "number_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "number_text.h"

namespace cdfr::command {
namespace {

/// The whole word as a number; a leading + is taken too, as people write it.
template <class Number>
bool parse(std::string_view word, Number& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stopped == end;
}

std::string range_text(const Range& range) {
  const Range all;
  if (range.least == all.least && range.greatest == all.greatest) return "a finite number";
  if (range.greatest == all.greatest) return "a number from " + short_text(range.least);
  return "a number from " + short_text(range.least) + " to " + short_text(range.greatest);
}

template <class Count>
CLI::Option* add_whole(CLI::App& verb, const std::string& name, Count& target, Count least, Count greatest,
                       const std::string& description) {
  const auto set = [name, least, greatest, &target](const std::string& word) {
    Count value = 0;
    if (!parse(word, value) || value < least || value > greatest) {
      throw CLI::ValidationError(name, "'" + word + "' is not a whole number from " + std::to_string(least) +
                                           " to " + std::to_string(greatest));
    }
    target = value;
  };
  return verb.add_option_function<std::string>(name, set, description)->type_name("COUNT");
}

}  // namespace

bool parse_number(const std::string& word, double& value) {
  return parse(std::string_view(word), value) && std::isfinite(value);
}

CLI::Option* add_number(CLI::App& verb, const std::string& name, double& target, const Range& range,
                        const std::string& description) {
  const auto set = [name, range, &target](const std::string& word) {
    double value = 0;
    if (!parse(word, value) || !(value >= range.least && value <= range.greatest)) {
      throw CLI::ValidationError(name, "'" + word + "' is not " + range_text(range));
    }
    target = value;
  };
  return verb.add_option_function<std::string>(name, set, description)->type_name("NUMBER");
}

CLI::Option* add_count(CLI::App& verb, const std::string& name, int& target, int least, int greatest,
                       const std::string& description) {
  return add_whole(verb, name, target, least, greatest, description);
}

CLI::Option* add_count(CLI::App& verb, const std::string& name, std::uint64_t& target, std::uint64_t least,
                       std::uint64_t greatest, const std::string& description) {
  return add_whole(verb, name, target, least, greatest, description);
}

CLI::Option* add_size(CLI::App& verb, const std::string& name, std::uint64_t& target,
                      const std::string& description) {
  const auto set = [name, &target](const std::string& word) {
    const std::size_t digits = std::min(word.find_first_not_of("0123456789"), word.size());
    const std::string unit = word.substr(digits);
    std::uint64_t value = 0;
    int shift = -1;
    if (unit.empty() || unit == "B") shift = 0;
    if (unit == "KiB") shift = 10;
    if (unit == "MiB") shift = 20;
    if (unit == "GiB") shift = 30;
    if (unit == "TiB") shift = 40;
    if (shift < 0 || !parse(word.substr(0, digits), value) || value == 0 ||
        value >= std::uint64_t{1} << (62 - shift))
      throw CLI::ValidationError(name, "'" + word + "' is not a size such as 500MiB or 2GiB");
    target = value << shift;
  };
  return verb.add_option_function<std::string>(name, set, description)->type_name("SIZE");
}

}  // namespace cdfr::command
