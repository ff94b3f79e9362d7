#include "cli/program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

namespace cdfr {
namespace {

constexpr std::chrono::seconds longest_run{60};
/// As waitpid tells an exit status of 127.
constexpr int not_started = 127 << 8;

std::string read_all(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::filesystem::path fresh_folder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "cdfr-cli-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) ADD_FAILURE() << "no folder for the test";
  return pattern;
}

/// Signals as a shell in the foreground leaves them, whatever the test runner ignores.
void set_signals(posix_spawnattr_t& attributes) {
  sigset_t all;
  sigemptyset(&all);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&all, signal);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
}

}  // namespace

nlohmann::json Outcome::json() const {
  nlohmann::json parsed = nlohmann::json::parse(output, nullptr, false);
  EXPECT_FALSE(parsed.is_discarded()) << "no JSON: " << output;
  EXPECT_TRUE(parsed.is_object()) << output;
  return parsed.is_object() ? parsed : nlohmann::json::object();
}

bool Outcome::one_error_line() const {
  return errors.rfind("cdfr: ", 0) == 0 && errors.find('\n') == errors.size() - 1;
}

Program::Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                 const std::string& standard_input)
    : folder_(folder) {
  std::ofstream(folder_ / "in", std::ios::binary) << standard_input;
  std::vector<std::string> words{CDFR_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const int written = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, 0, (folder_ / "in").c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, (folder_ / "out").c_str(), written, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, (folder_ / "err").c_str(), written, 0600);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  set_signals(attributes);
  const int failed = ::posix_spawn(&process_, CDFR_PROGRAM, &actions, &attributes, pointers.data(), environ);
  if (failed != 0) {
    ADD_FAILURE() << "cannot start " << CDFR_PROGRAM;
    process_ = -1;
    ended_ = not_started;
  }
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
}

/// A number of 0 or below would name other processes than the one that was started.
void Program::send(int signal) const {
  if (process_ > 0 && ended_ < 0) ::kill(process_, signal);
}

bool Program::running() {
  if (ended_ >= 0) return false;
  int how = 0;
  const pid_t ended = ::waitpid(process_, &how, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return true;
  ended_ = ended == process_ ? how : not_started;
  return false;
}

Outcome Program::wait() {
  const auto start = std::chrono::steady_clock::now();
  bool killed = false;
  while (running()) {
    if (!killed && std::chrono::steady_clock::now() - start > longest_run) {
      ADD_FAILURE() << "the program had to be killed";
      send(SIGKILL);
      killed = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  const int status = WIFEXITED(ended_) ? WEXITSTATUS(ended_) : 256 + WTERMSIG(ended_);
  return {status, read_all(folder_ / "out"), read_all(folder_ / "err")};
}

void CliTest::SetUp() {
  folder_ = fresh_folder();
  streams_ = fresh_folder();
}

void CliTest::TearDown() {
  std::error_code ignored;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  if (!streams_.empty()) std::filesystem::remove_all(streams_, ignored);
}

Outcome CliTest::run(const std::vector<std::string>& arguments, const std::string& standard_input) const {
  return Program(streams_, arguments, standard_input).wait();
}

Program CliTest::start(const std::vector<std::string>& arguments) const { return {streams_, arguments}; }

std::string CliTest::part(const std::string& name, const std::string& file) const {
  const Outcome made = run({"make-part", name, "-o", path(file)});
  EXPECT_EQ(made.status, 0) << made.errors;
  return path(file);
}

void CliTest::put(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string CliTest::text_of(const std::string& name) const { return read_all(folder_ / name); }

std::vector<std::string> CliTest::names_but(const std::vector<std::string>& but) const {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (std::find(but.begin(), but.end(), name) == but.end()) found.push_back(name);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace cdfr
