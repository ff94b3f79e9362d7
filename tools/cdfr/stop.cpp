#include "stop.h"

#include "interrupt.h"
#include "terminal_text.h"

namespace cdfr::command {

void stop_failed(const std::filesystem::path& file, const std::string& text) {
  const std::string name = file == "-" ? "standard input" : terminal_text(file.string());
  throw Stop(status_failed, name + ": " + terminal_text(text));
}

void stop_usage(const std::string& text) { throw Stop(status_usage, terminal_text(text)); }

void stop_if_interrupted() {
  if (received_signal() != 0) throw Stop(status_signal + received_signal(), "interrupted");
}

void stop_for(const Error& error, const std::filesystem::path& file) {
  if (error.code == Code::cancelled) stop_if_interrupted();
  if (error.code == Code::bad_option) stop_usage(error.text);
  stop_failed(file, error.text);
}

}  // namespace cdfr::command
