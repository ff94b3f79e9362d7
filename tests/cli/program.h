/// Runs the cdfr program in a folder of its own and gives back what it said.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cdfr {

struct Outcome {
  int status = -1;  ///< exit status, or 256 + the signal that ended it
  std::string output, errors;

  /// Standard output as the one JSON object that it must be.
  nlohmann::json json() const;
  /// Exactly one line on standard error, and it begins with "cdfr: ".
  bool one_error_line() const;
};

/// A program that has been started, its streams tied to files in `folder`.
class Program {
 public:
  Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
          const std::string& standard_input = {});
  void send(int signal) const;
  bool running();
  /// A program that takes more than a minute is killed, and that is a failure.
  Outcome wait();

 private:
  std::filesystem::path folder_;
  pid_t process_ = -1;
  int ended_ = -1;
};

/// Each test has a fresh folder; relative names are taken from `folder()`.
class CliTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  const std::filesystem::path& folder() const { return folder_; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  Outcome run(const std::vector<std::string>& arguments, const std::string& standard_input = {}) const;
  Program start(const std::vector<std::string>& arguments) const;
  /// A made part, written into the folder by the program itself.
  std::string part(const std::string& name, const std::string& file) const;
  void put(const std::string& name, const std::string& text) const;
  std::string text_of(const std::string& name) const;
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  /// Everything in the folder but `but`, hidden files too.
  std::vector<std::string> names_but(const std::vector<std::string>& but) const;

 private:
  std::filesystem::path folder_, streams_;
};

}  // namespace cdfr
