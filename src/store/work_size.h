/// What a build on disk takes, before it has begun.
#pragma once

#include <cstdint>
#include <filesystem>

namespace cdfr {

/// Anonymous memory without which build_file cannot work: the program and its workers' blocks, and for
/// formats other than binary STL the mesh while it is read.
std::uint64_t least_memory(const std::filesystem::path& mesh, unsigned threads);

/// Disk that build_file takes at its peak, about.
std::uint64_t disk_for(const std::filesystem::path& mesh);

}  // namespace cdfr
