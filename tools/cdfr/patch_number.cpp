#include "patch_number.h"

#include <algorithm>
#include <charconv>

#include "stop.h"

namespace cdfr::command {
namespace {

std::uint32_t patch_of(const std::string& option, const std::string& name, const Input& input) {
  if (input.mesh) {
    const std::vector<std::string>& names = input.mesh->patch_names;
    const auto at = std::find(names.begin(), names.end(), name);
    if (at != names.end()) return static_cast<std::uint32_t>(at - names.begin());
  }
  std::uint32_t number = 0;
  const char* end = name.data() + name.size();
  const auto read = std::from_chars(name.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end)
    stop_usage(option + ": no patch is called '" + name + "', and it is no number");
  return number;
}

}  // namespace

std::vector<std::uint32_t> patch_numbers(const std::string& option, const std::vector<std::string>& names,
                                         const Input& input) {
  std::vector<std::uint32_t> numbers;
  for (const std::string& name : names) numbers.push_back(patch_of(option, name, input));
  return numbers;
}

}  // namespace cdfr::command
