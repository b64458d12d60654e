#include "stop_request.hpp"

namespace ringfilm::app {
namespace {

// A signal has no other way to report itself. 0: none came.
volatile std::sig_atomic_t signal_received = 0;

/// @returns what was done about the signal before; nothing where it is ignored, and stays so
std::optional<struct sigaction> note(int number) {
  struct sigaction before {};
  if (::sigaction(number, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) return std::nullopt;
  struct sigaction action {};
  action.sa_handler = [](int received) { signal_received = received; };
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  ::sigaction(number, &action, nullptr);
  return before;
}

}  // namespace

StopRequest::StopRequest() {
  signal_received = 0;
  interrupt_before_ = note(SIGINT);
  kill_before_ = note(SIGTERM);
}

StopRequest::~StopRequest() {
  if (interrupt_before_) ::sigaction(SIGINT, &*interrupt_before_, nullptr);
  if (kill_before_) ::sigaction(SIGTERM, &*kill_before_, nullptr);
}

bool StopRequest::is_made() const { return signal_received != 0; }

Stopped StopRequest::stopped(const std::string& message) const { return {message, signal_received}; }

}  // namespace ringfilm::app
