/// Where a result is to go, looked at before the work begins.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace cdfr::command {

/// The extension in lower case, with its dot.
std::string extension_of(const std::filesystem::path& path);

/// Refuses what would fail after the work: an extension that is none of these is wrong usage; a missing
/// directory, one that may not be written, or a target that is no regular file has failed.
void check_target(const std::filesystem::path& path, std::initializer_list<std::string_view> extensions);

}  // namespace cdfr::command
