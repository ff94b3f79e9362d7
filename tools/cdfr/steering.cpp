#include "steering.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace cdfr::command {
namespace {

constexpr std::chrono::milliseconds between_draws{100};

}  // namespace

Steering::Steering(const Settings& settings, std::string what, OnSignal on_signal)
    : threads_(static_cast<unsigned>(settings.threads)),
      what_(std::move(what)),
      drawing_(!settings.quiet && ::isatty(STDERR_FILENO) == 1),
      next_draw_(std::chrono::steady_clock::now() + between_draws) {
  if (on_signal == OnSignal::cancel) defer_.emplace();
}

Steering::~Steering() {
  if (drawing_) std::fputs("\r\x1b[K", stderr);
}

void Steering::share(double from, double to) noexcept {
  from_ = from;
  to_ = to;
}

bool Steering::tick(void* steering, double done) noexcept {
  auto& self = *static_cast<Steering*>(steering);
  if (self.drawing_) self.draw(self.from_ + (self.to_ - self.from_) * done);
  return received_signal() == 0;
}

void Steering::draw(double done) noexcept {
  const int percent = static_cast<int>(100 * done);
  const auto now = std::chrono::steady_clock::now();
  if (percent == drawn_ || now < next_draw_) return;
  drawn_ = percent;
  next_draw_ = now + between_draws;
  std::fprintf(stderr, "\r%s %3d %%\x1b[K", what_.c_str(), percent);
  std::fflush(stderr);
}

}  // namespace cdfr::command
