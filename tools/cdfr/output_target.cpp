#include "output_target.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "stop.h"

namespace cdfr::command {
namespace {

void check_extension(const std::filesystem::path& path, std::initializer_list<std::string_view> extensions) {
  const std::string extension = extension_of(path);
  if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) return;
  std::string known;
  for (const std::string_view one : extensions) known += (known.empty() ? "" : ", ") + std::string(one);
  stop_usage("output '" + path.string() + "' must end in " + (extensions.size() > 1 ? "one of " : "") +
             known);
}

std::string reason() { return std::generic_category().message(errno); }

}  // namespace

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& letter : extension) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return extension;
}

void check_target(const std::filesystem::path& path, std::initializer_list<std::string_view> extensions) {
  check_extension(path, extensions);
  std::error_code ignored;
  const auto parent = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const auto parent_status = std::filesystem::status(parent, ignored);
  if (!std::filesystem::exists(parent_status)) stop_failed(path, "its directory does not exist");
  if (!std::filesystem::is_directory(parent_status)) stop_failed(path, "its directory is no directory");
  if (::access(parent.c_str(), W_OK | X_OK) != 0)
    stop_failed(path, "cannot write in its directory: " + reason());
  const auto status = std::filesystem::symlink_status(path, ignored);
  if (!std::filesystem::exists(status)) return;
  if (!std::filesystem::is_regular_file(status)) stop_failed(path, "is there and no regular file");
  if (::access(path.c_str(), W_OK) != 0) stop_failed(path, "may not be replaced: " + reason());
}

}  // namespace cdfr::command
