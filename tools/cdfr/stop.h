/// How a verb ends early: with an exit status and one line for the reader.
#pragma once

#include <exception>
#include <filesystem>
#include <string>
#include <utility>

#include "cdfr/core/result.h"

namespace cdfr::command {

enum Status : int { status_done = 0, status_failed = 1, status_usage = 2, status_signal = 128 };

/// Thrown by verbs, caught in main.
class Stop : public std::exception {
 public:
  /// `line` is fit for a terminal and does not begin with the program's name.
  Stop(int status, std::string line) : status_(status), line_(std::move(line)) {}
  int status() const noexcept { return status_; }
  const char* what() const noexcept override { return line_.c_str(); }

 private:
  int status_;
  std::string line_;
};

/// Status 1: "FILE: what and where".
[[noreturn]] void stop_failed(const std::filesystem::path& file, const std::string& text);
/// Status 2.
[[noreturn]] void stop_usage(const std::string& text);
/// Status 128 + the signal, if one came in.
void stop_if_interrupted();
/// A cancelled call by its signal, a bad option as wrong usage, all else as failed at `file`.
[[noreturn]] void stop_for(const Error& error, const std::filesystem::path& file);

/// The value, or the end of the program.
template <class T>
T need(Result<T> result, const std::filesystem::path& file) {
  if (!result) stop_for(result.error(), file);
  return std::move(*result);
}
inline void need(const Result<void>& result, const std::filesystem::path& file) {
  if (!result) stop_for(result.error(), file);
}

}  // namespace cdfr::command
