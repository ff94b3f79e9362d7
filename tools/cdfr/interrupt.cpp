#include "interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <string_view>

namespace cdfr::command {
namespace {

std::atomic<int> received{0};
std::atomic<int> deferred{0};
std::atomic<int> times{0};

/// More than a terminal and a wrapper around the program send for one key.
constexpr int most_patience = 3;

static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void note(int signal) {
  int none = 0;
  received.compare_exchange_strong(none, signal);
  if (deferred.load() > 0 && ++times < most_patience) return;
  constexpr std::string_view line = "cdfr: interrupted\n";
  [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, line.data(), line.size());
  ::_exit(128 + received.load());
}

}  // namespace

void catch_interrupts() noexcept {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
  }
}

int received_signal() noexcept { return received.load(); }

DeferInterrupts::DeferInterrupts() noexcept { ++deferred; }
DeferInterrupts::~DeferInterrupts() { --deferred; }

}  // namespace cdfr::command
