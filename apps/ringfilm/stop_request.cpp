#include "stop_request.hpp"

#include <csignal>

namespace ringfilm::app {
namespace {

// A signal has no other way to say that it came.
volatile std::sig_atomic_t stop_wanted = 0;

constexpr int kSignals[] = {SIGINT, SIGTERM};

}  // namespace

StopRequest::StopRequest() {
  stop_wanted = 0;
  struct sigaction action {};
  action.sa_handler = [](int) { stop_wanted = 1; };
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  for (const int number : kSignals) ::sigaction(number, &action, nullptr);
}

StopRequest::~StopRequest() {
  for (const int number : kSignals) std::signal(number, SIG_DFL);
}

bool StopRequest::is_made() const { return stop_wanted != 0; }

}  // namespace ringfilm::app
