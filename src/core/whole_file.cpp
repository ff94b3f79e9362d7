#include "core/whole_file.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cdfr {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 18;

/// strerror_r has two signatures; overloads take whichever the system has.
[[maybe_unused]] const char* chosen_text(const char* returned, const char*) { return returned; }
[[maybe_unused]] const char* chosen_text(int failed, const char* buffer) {
  return failed == 0 ? buffer : "unknown error";
}

Error system_error(const std::string& what, int number, std::uint64_t where = 0) {
  std::array<char, 256> buffer{};
  const char* reason = chosen_text(::strerror_r(number, buffer.data(), buffer.size()), buffer.data());
  return {Code::file_write, where, what + ": " + reason};
}

/// Repeats a call that a signal interrupted.
template <class Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

class Descriptor {
 public:
  explicit Descriptor(int number = -1) noexcept : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int get() const noexcept { return number_; }
  /// Never called twice for one descriptor, not even after EINTR: it is gone then too.
  int close() noexcept { return ::close(std::exchange(number_, -1)); }

 private:
  int number_;
};

const char* kind_text(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISLNK(mode)) return "a symbolic link";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

/// The rename would replace whatever is there, so what is there must be an ordinary file that may be written.
std::optional<Error> refuse_target(int directory, const std::string& name) {
  struct stat status {};
  if (::fstatat(directory, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
    if (errno == ENOENT) return std::nullopt;
    return system_error("cannot look at the target", errno);
  }
  if (!S_ISREG(status.st_mode)) {
    return Error{Code::file_write, 0,
                 std::string("is ") + kind_text(status.st_mode) + ", not a regular file"};
  }
  if (::faccessat(directory, name.c_str(), W_OK, AT_EACCESS) != 0) {
    return system_error("may not be replaced", errno);
  }
  return std::nullopt;
}

/// A short name, so that a target name of the greatest legal length works too.
std::optional<std::string> random_name() {
  std::array<unsigned char, 12> bytes{};
  const auto got = uninterrupted([&] { return ::getrandom(bytes.data(), bytes.size(), 0); });
  if (got != static_cast<ssize_t>(bytes.size())) return std::nullopt;
  std::string name = ".cdfr-";
  for (const unsigned char byte : bytes) {
    name += "0123456789abcdef"[byte >> 4];
    name += "0123456789abcdef"[byte & 15];
  }
  return name + ".part";
}

}  // namespace

struct WholeFile::State {
  Descriptor directory;
  Descriptor file;
  std::string target;
  std::string temporary;  ///< empty once renamed
  std::vector<std::byte> buffer;
  std::uint64_t flushed = 0;
  std::optional<Error> failed;

  Result<void> fail(Error error) { return failed = std::move(error), *failed; }
  Result<void> put(std::uint64_t offset, std::span<const std::byte> bytes);
  Result<void> flush();
  Result<void> replace_target();
};

void WholeFile::Discard::operator()(State* state) const noexcept {
  if (!state->temporary.empty()) ::unlinkat(state->directory.get(), state->temporary.c_str(), 0);
  delete state;
}

Result<WholeFile> WholeFile::create(const std::filesystem::path& path) {
  std::unique_ptr<State, Discard> state(new State);
  state->target = path.filename().string();
  if (state->target.empty() || state->target == "." || state->target == "..") {
    return Error{Code::file_write, 0, "is no file name"};
  }
  if (path.native().find('\0') != std::string::npos) {
    return Error{Code::file_write, 0, "has a zero byte in its name"};
  }
  const std::string parent = path.has_parent_path() ? path.parent_path().string() : ".";
  state->directory =
      Descriptor(uninterrupted([&] { return ::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); }));
  if (state->directory.get() < 0) return system_error("cannot open its directory", errno);
  const int directory = state->directory.get();
  if (auto refusal = refuse_target(directory, state->target)) return *refusal;

  for (int attempt = 0; attempt < 16; ++attempt) {
    const auto name = random_name();
    if (!name) return system_error("cannot name a temporary file", errno);
    const int flags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    state->file = Descriptor(uninterrupted([&] { return ::openat(directory, name->c_str(), flags, 0666); }));
    if (state->file.get() >= 0) {
      state->temporary = *name;
      state->buffer.reserve(buffer_bytes);
      return WholeFile(std::move(state));
    }
    if (errno != EEXIST) break;
  }
  return system_error("cannot create a file in its directory", errno);
}

Result<void> WholeFile::State::put(std::uint64_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = uninterrupted(
        [&] { return ::pwrite(file.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset)); });
    // A zero is no error by the letter of the standard, and would loop for ever.
    if (done <= 0) {
      const int number = done < 0 ? errno : ENOSPC;
      return fail(system_error("cannot write at byte " + std::to_string(offset), number, offset));
    }
    offset += static_cast<std::uint64_t>(done);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
  return {};
}

Result<void> WholeFile::State::flush() {
  auto written = put(flushed, buffer);
  if (!written) return written;
  flushed += buffer.size();
  buffer.clear();
  return {};
}

Result<void> WholeFile::write(std::span<const std::byte> bytes) {
  State& state = *state_;
  if (state.failed) return *state.failed;
  if (state.buffer.size() + bytes.size() > buffer_bytes) {
    if (auto flushed = state.flush(); !flushed) return flushed;
    if (bytes.size() > buffer_bytes) {
      if (auto written = state.put(state.flushed, bytes); !written) return written;
      state.flushed += bytes.size();
      return {};
    }
  }
  state.buffer.insert(state.buffer.end(), bytes.begin(), bytes.end());
  return {};
}

Result<void> WholeFile::write(std::string_view text) { return write(std::as_bytes(std::span(text))); }

Result<void> WholeFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  State& state = *state_;
  assert(offset <= size() && bytes.size() <= size() - offset);
  if (state.failed) return *state.failed;
  if (auto flushed = state.flush(); !flushed) return flushed;
  return state.put(offset, bytes);
}

Result<void> WholeFile::write_at(std::uint64_t offset, std::string_view text) {
  return write_at(offset, std::as_bytes(std::span(text)));
}

std::uint64_t WholeFile::size() const noexcept { return state_->flushed + state_->buffer.size(); }

Result<void> WholeFile::State::replace_target() {
  if (uninterrupted([&] { return ::fsync(file.get()); }) != 0)
    return fail(system_error("cannot sync", errno));
  if (file.close() != 0 && errno != EINTR) return fail(system_error("cannot close", errno));
  // Once more, for the work between may have taken hours: a directory or device that came up since is left
  // alone.
  if (auto refusal = refuse_target(directory.get(), target)) return fail(*refusal);
  if (::renameat(directory.get(), temporary.c_str(), directory.get(), target.c_str()) != 0) {
    return fail(system_error("cannot rename the temporary file", errno));
  }
  temporary.clear();
  // Some file systems have no sync for directories and say so; the rename itself has happened.
  const int synced = uninterrupted([&] { return ::fsync(directory.get()); });
  if (synced != 0 && errno != EINVAL && errno != ENOTSUP) {
    return fail(system_error("cannot sync its directory", errno));
  }
  return {};
}

Result<void> WholeFile::finish() {
  State& state = *state_;
  if (state.failed) return *state.failed;
  assert(!state.temporary.empty());
  if (auto flushed = state.flush(); !flushed) return flushed;
  return state.replace_target();
}

}  // namespace cdfr
